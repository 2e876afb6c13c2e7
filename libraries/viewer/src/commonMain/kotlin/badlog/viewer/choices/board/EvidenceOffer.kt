package badlog.viewer.choices.board

import badlog.core.analysis.LogView
import badlog.signals.LogShape
import badlog.signals.vocabulary.SignalVocabulary

/**
 * Graphs that may help to investigate a finding, in addition to its evidence.
 *
 * @property label the content of the graphs, as in “+ Current”.
 * @property topics the full names of the topics.
 */
class EvidenceOffer(val label: String, val topics: List<String>)

/** Returns offers for the well-known signals of [vocabulary] in [view] that [board] does not show yet. */
fun evidenceOffers(view: LogView, vocabulary: SignalVocabulary, board: Board): List<EvidenceOffer> {
    val topics = LogShape.of(view).topicsOf(vocabulary).all
    val shown = board.placesOfLines().keys
    return OFFERED.mapNotNull { (label, signals) ->
        val names = signals.flatMap { signal -> topics.filter { it.signal == signal } }.map { it.topic }.distinct()
        if (names.isEmpty() || names.any { it in shown }) null else EvidenceOffer(label, names)
    }
}

/** Returns this board with graphs of [offer] below its own; [vocabulary] provides units for topics without one. */
fun Board.with(offer: EvidenceOffer, view: LogView, vocabulary: SignalVocabulary): Board =
    withGraphs(evidenceBoard(view, offer.topics, vocabulary).graphs)

private val OFFERED = listOf(
    "Voltage" to listOf("battery"),
    "Current" to listOf("total current", "channel current"),
    "Outputs" to listOf("motor output", "motor voltage"),
    "Modes" to listOf("robot enabled", "robot autonomous", "robot teleop"),
    "Loop time" to listOf("loop time"),
)
