package badlog.rules.incident

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.rules.timeText

/**
 * Findings that belong together: the likely cause, and its effects.
 *
 * @property name the event, such as “The robot pushed against something”.
 * @property severity the worst severity of its findings.
 * @property causes the findings that show the cause; at least one.
 * @property effects the findings that followed, in the order of time.
 * @property next the next step, as a sentence; empty if not given.
 * @property difference its difference from the team's other matches; null if none is known.
 */
class Incident internal constructor(
    val name: String,
    val causes: List<Finding>,
    val effects: List<Finding>,
    val next: String,
    val difference: Finding? = null,
) {
    val severity: Severity = (causes + effects).maxOf { it.severity }

    /** The finding at its beginning: its first cause. If that is about the whole log, it is the first effect that [sentences] mention. */
    val first: Finding get() = causes[0].takeUnless { it.time.isNaN() } ?: firstMentioned ?: effects.firstOrNull() ?: causes[0]

    private val firstMentioned get() = sentences.map { it.finding }.firstOrNull { !it.time.isNaN() }

    /** The time of its beginning, in the unit of x. NaN if its cause is about the whole log and no effect has a time. */
    val time: Double get() = first.time

    /** The unit of [time]. */
    val timeUnit: String get() = causes[0].timeUnit

    /** Its description: the likely cause, the worst effects, and the difference from other matches. Each has the finding that shows it. */
    val sentences: List<Sentence>
        get() {
            val reported = effects.filter {
                it.severity != Severity.NOTE && !isNamedByCause(it)
            }.sortedByDescending { it.severity }.distinctBy { it.rule }.take(MAX_EFFECTS)
            return listOf(Sentence("Likely cause: ${name.replaceFirstChar { it.lowercase() }}. ${causes[0].text}", causes[0])) +
                reported.sortedBy { it.time }.map { Sentence(after(it) + it.text, it) } +
                listOfNotNull(difference?.let { Sentence(it.text, it) })
        }

    /** The effects that [sentences] omit. */
    val others: List<Finding> get() = sentences.mapTo(HashSet()) { it.finding }.let { reported -> effects.filter { it !in reported } }

    /** The full names of the topics that show the content of [sentences], in order. */
    val evidence: List<String> get() = sentences.flatMap { it.finding.evidence }.distinct()

    /** Returns whether [finding] is a part of it. */
    operator fun contains(finding: Finding): Boolean = finding in causes || finding in effects

    /** Returns whether it is the same as a cause at the same moment. A stalled loop, for example, need not be mentioned twice. */
    private fun isNamedByCause(effect: Finding) =
        effect.topic != null && causes.any { it.time == effect.time && effect.topic in it.evidence }

    private fun after(effect: Finding): String {
        val later = effect.time - causes[0].time
        return if (later >= MIN_LATER) "${timeText(rounded(later), timeUnit)} later: " else ""
    }

    private fun rounded(time: Double) = kotlin.math.round(time * 10) / 10

    /**
     * A part of the description of an incident.
     *
     * @property text one or two sentences.
     * @property finding the finding that shows it, with its time and its topics.
     */
    class Sentence internal constructor(val text: String, val finding: Finding)
}

/** Returns the full names of the topics that show [finding]. If it is part of this incident, the incident's topics follow. */
fun Incident?.evidenceOf(finding: Finding): List<String> = (finding.evidence + this?.evidence.orEmpty()).distinct()

/**
 * Returns the full names of the topics that show the first of [incidents]. Without any incident, they show the first of [worstFirst] that is more
 * than a note. Empty if there is neither.
 */
fun firstEvidenceOf(incidents: List<Incident>, worstFirst: List<Finding>): List<String> =
    incidents.firstOrNull()?.evidence ?: worstFirst.firstOrNull { it.severity != Severity.NOTE }?.evidence.orEmpty()

/**
 * Returns the next step for [finding]: this incident's, if the finding is part of one that has it, otherwise the finding's. May be empty.
 */
fun Incident?.nextOf(finding: Finding): String = this?.next.orEmpty().ifEmpty { finding.next }

private const val MAX_EFFECTS = 2

// Effects that begin less than this after a cause count as simultaneous.
private const val MIN_LATER = 0.1
