# SPDX-License-Identifier: BSD-3-Clause
"""The sums of the test reports count failures that a careless reader would lose."""

import tally

REPORT = """<testsuite>
<testcase name="a"/>
<testcase name="b"><failure/></testcase>
<testcase name="c"><error/></testcase>
<testcase name="d"><skipped/></testcase>
</testsuite>"""


def test_outcomes_are_told_apart(tmp_path):
    report = tmp_path / "report.xml"
    report.write_text(REPORT)
    assert tally.count(str(report)) == (1, 2, 1)


def test_a_missing_or_broken_report_is_a_failure(tmp_path):
    broken = tmp_path / "broken.xml"
    broken.write_text(REPORT[:40])
    assert tally.count(str(broken)) == (0, 1, 0)
    assert tally.count(str(tmp_path / "none.xml")) == (0, 1, 0)
