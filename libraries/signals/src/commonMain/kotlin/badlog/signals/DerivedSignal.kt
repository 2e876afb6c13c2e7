package badlog.signals

import badlog.core.analysis.Series

/**
 * A signal for rules that is calculated from topics of a log, such as a part's distance from its target. `docs/signals.md` lists them.
 *
 * @property name the name in rules; several parts may have it.
 * @property unit the unit of its samples; empty for none.
 * @property device the part of the robot that it is about, for people; empty for the whole robot.
 * @property topics the full names of the topics that it is calculated from and that show it, the most important first.
 */
class DerivedSignal internal constructor(
    val name: String,
    val unit: String,
    val device: String,
    val topics: List<String>,
    internal val samples: (NamedSamples) -> Series,
)
