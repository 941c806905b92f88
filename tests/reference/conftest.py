# SPDX-License-Identifier: BSD-3-Clause
"""Makes the package and the helpers of the verification importable."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "verification"), str(Path(__file__).parent)]
