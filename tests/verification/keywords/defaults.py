"""What a dustProperties leaves to the defaults, written out: to be put at its end.

    defaults.py PAGE FILE: PAGE of dustFoam -keywords; each default that is a value, of what FILE has
"""
import re
import sys

page, file = sys.argv[1:]
text = open(file).read()
text = re.sub(r"//[^\n]*|/\*.*?\*/|FoamFile\s*\{.*?\}", "", text, flags=re.S)
tokens = re.findall(r'"[^"]*"|[{};]|[^\s{};"]+', text)


def block():
    """A dictionary, up to its brace: values are texts or dictionaries."""
    entries, words = {}, []
    while tokens:
        token = tokens.pop(0)
        if token == "}":
            break
        if token == "{":
            entries[words[0]] = block()
            words = []
        elif token == ";":
            entries[words[0]] = " ".join(words[1:])
            words = []
        else:
            words.append(token.strip('"'))
    return entries


def places(entries, path):
    """Dictionaries that a path stands for: with the model that each is of, and its own path."""
    found = [(entries, "", [])]
    for part in path:
        deeper = []
        for d, model, names in found:
            for name, value in d.items():
                if part in ("*", name) and isinstance(value, dict):
                    own = value.get("type", value.get("model", name.replace("Distribution", "")))
                    deeper.append((value, own, names + [name]))
                elif part in ("*", name) and names[-1:] == ["particleForces"] and value == "":
                    deeper.append(({}, name, names + [name]))       # `gravity;`
            if part != "*" and part not in d:
                deeper.append(({}, "", names + [part]))
        found = deeper
    return found


def isValue(default):
    return re.fullmatch(r"-?[\d.]+(e[-+]?\d+)?|\([-\d. ]+\)|constant \d+|\w+", default) and default != "none"


tree = block()
for line in open(page):
    cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
    if not cells[0].startswith("`"):
        continue
    path, models, default = cells[0].strip("`").split("/"), cells[1].split(), cells[3]
    if path[-1] == "*" or not isValue(default):
        continue
    for d, model, names in places(tree, path[:-1]):
        # of contacts, a part without a model is merged over the default's
        if (models and model not in models) or path[-1] in d or names[-1:] == ["none"]:
            continue
        if names[:1] == ["contact"] and len(names) > 2 and "model" not in d:
            continue
        quoted = ['"%s"' % n for n in names]
        print(" { ".join(quoted + [f"{path[-1]} {default};"]) + " }"*len(names))
