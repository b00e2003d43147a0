# SPDX-License-Identifier: LGPL-2.1-or-later
"""worked_examples.py PROGRAM: plan and select still say what doc/validation/worked-examples.md has beside textbooks and tables."""
import difflib
import subprocess
import sys

import program
from program import check

page = (program.REPOSITORY / "doc/validation/worked-examples.md").read_text()
done = subprocess.run([sys.executable, "-B", program.REPOSITORY / "scripts/worked_examples.py", "--program", sys.argv[1]], capture_output=True, text=True)
check(done.returncode == 0, done.stderr)
changes = [line for line in difflib.unified_diff(page.splitlines(), done.stdout.splitlines(), "the page", "the program", n=0, lineterm="")]
check(not changes, "\n".join(changes))
rows = [line for line in page.splitlines() if line.startswith("| ") and line.endswith(" |")]
unexplained = [row for row in rows if "differs" in row and row.rstrip(" |").endswith("differs") and " teeth, " not in row]
check(len(rows) > 60 and not unexplained, f"{len(rows)} rows, without a reason: {unexplained}")
