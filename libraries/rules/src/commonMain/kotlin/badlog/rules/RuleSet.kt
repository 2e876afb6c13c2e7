package badlog.rules

import badlog.rules.cause.CauseGraph
import badlog.signals.vocabulary.SignalVocabulary

/**
 * Rules to run over logs, and the names they use. `docs/rules.md` has the format of their file.
 *
 * @property rules the rules, in the order of the file; no two have the same name.
 * @property signals the names of topics that rules refer to by their meaning.
 * @property causes the causes and effects among findings.
 * @property comparisons rules that compare a log with the team's others.
 * @property devices the team's names for the devices on its CAN bus.
 */
class RuleSet internal constructor(
    internal val aliases: List<Alias>,
    val rules: List<Rule>,
    val signals: SignalVocabulary,
    val causes: CauseGraph,
    val comparisons: List<ComparisonRule> = emptyList(),
    val devices: DeviceNames = DeviceNames.NONE,
) {
    /** The items to check before each match, in the order of the rules, each once. Empty in rules of a page. */
    val checklist: List<String> get() = rules.map { it.checklist }.filter { it.isNotBlank() }.distinct()

    /** Returns these rules with [signals] as the names of topics. */
    fun with(signals: SignalVocabulary): RuleSet = RuleSet(aliases, rules, signals, causes, comparisons, devices)

    /** Returns these rules with [devices] as the names of devices. */
    internal fun with(devices: DeviceNames): RuleSet = RuleSet(aliases, rules, signals, causes, comparisons, devices)

    companion object {
        val NONE: RuleSet = RuleSet(emptyList(), emptyList(), SignalVocabulary.NONE, CauseGraph.NONE)
    }
}
