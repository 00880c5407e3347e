"""The table of keywords (dustFoam -keywords) against what headers show and what the code reads.

    compare.py PAGE TREE: one line "what" for each difference, exit code 1 if there is one
"""
import os
import re
import sys

page, tree = sys.argv[1:]
rows = []
for line in open(page):
    cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
    if cells[0].startswith("`"):
        rows.append((cells[0].strip("`"), cells[1], cells[2], cells[3], cells[4], cells[5]))
wrong = []

# Every row says what it is
for path, models, unit, default, allowed, meaning in rows:
    if not unit or not meaning or not default:
        wrong.append(f"{path} has no unit, default or meaning")


def usage(header):
    """Paths of the verbatim block of a header."""
    block = re.search(r"\\verbatim(.*?)\\endverbatim", open(header).read(), re.S).group(1)
    block = re.sub(r"//[^\n]*", "", block)
    tokens = re.findall(r'"[^"]*"|\.\.\.|[{}();]|[^\s{}();"]+', block)
    paths, stack, new = [], [], True
    for k, token in enumerate(tokens):
        if token == "{":
            stack.append(name)
            new = True
        elif token == "}":
            stack.pop()
            new = True
        elif token == ";":
            new = True
        elif new and token != "...":
            name = token.strip('"')
            paths.append("/".join(stack + [name]))
            new = False
    return paths


def matches(pattern, path):
    a, b = pattern.split("/"), path.split("/")
    return len(a) == len(b) and all(x in ("*", y) for x, y in zip(a, b))


shown = []
for header in ("src/dustCloud/dustProperties/dustProperties.H", "src/dustCloud/dustCloud/dustCloud.H"):
    shown += usage(os.path.join(tree, header))
for path in shown:
    if not any(matches(row[0], path) for row in rows):
        wrong.append(f"{path} is in a header and not in the table")
for path, models, *_, meaning in rows:
    # those of a law, of OpenFOAM's and of sub-models have headers of their own
    if models or "OpenFOAM" in meaning or re.match("constantProperties|subModels/|cloudFunctions/", path):
        continue
    if path.endswith("/model"):     # or short: `twisting none;`
        path = path[:-len("/model")]
    if not any(matches(path, s) for s in shown):
        wrong.append(f"{path} is in the table and not in a header")

# What the code reads of dictionaries that the table covers: the names of keywords
last = {row[0].split("/")[-1] for row in rows} | {"default"}    # of contact/*
read = re.compile(
    r'(?:\bget(?:OrDefault)?<\w+>|lookupOrDefault(?:<\w+>)?|readIfPresent|readEntry|subDict|subOrEmptyDict|findDict'
    r'|\blookup)\s*\(\s*"(\w+)"')
covered = ("dustProperties", "injectionModels", "distributionModels", "particleForces", "modelTable", "caseCheck",
           "dustCloud/dustCloud.C", "dustCloud/dustCloudMotion.C", "dustCloud/dustCloudReport.C")
found = set()
for folder, inside, files in os.walk(os.path.join(tree, "src/dustCloud")):
    inside[:] = [d for d in inside if d not in ("lnInclude", "Make")]
    for name in files:
        path = os.path.relpath(os.path.join(folder, name), os.path.join(tree, "src/dustCloud"))
        if name.endswith((".C", ".H")) and path.startswith(covered):
            code = re.sub(r"//[^\n]*|/\*.*?\*/", "", open(os.path.join(folder, name)).read(), flags=re.S)
            for keyword in read.findall(code):
                found.add(keyword)
                if keyword not in last:
                    wrong.append(f"{keyword} is read in {path} and not in the table")
if len(found) < 20:
    wrong.append(f"only {len(found)} keywords were found in the code")

print("\n".join(wrong))
sys.exit(1 if wrong else 0)
