# SPDX-License-Identifier: BSD-3-Clause
"""The regular network of Flemisch et al. (2018), case 1, with conductive fractures."""

from pathlib import Path

import criteria
from report import Chapter
from studies import check_example, compare_figure, expected_profiles

TITLE = "Regular fracture network (Flemisch et al. 2018, case 1)"


def check(chapter: Chapter, work: Path) -> None:
    result = check_example(chapter, "flemisch_regular", work)
    summary = result.results.summary
    chapter.at_most("balance.throughput", "what enters minus what leaves, over the throughput",
                    abs(sum(summary["rate_m2_per_s"].values())) / summary["throughput_m2_per_s"],
                    1e-10)
    for criterion in expected_profiles("flemisch_regular"):
        values = criteria.profile(criterion, result.results, "flemisch_regular")
        curve = (criterion["probe"], values.position, values.computed, values.expected)
        axis = criterion["position"][0]
        chapter.add_figure(compare_figure([curve], f"{axis}", "Pressure"),
                           f"Pressure on the {criterion['probe']} line; circles: published")
