package badlog.window.log

import badlog.core.analysis.LogView
import badlog.expression.ViewWithVirtualTopics
import badlog.files.LogFile
import badlog.signals.beginVirtualTopics
import badlog.signals.clock.FoundStation
import badlog.signals.clock.StationOverlay
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import badlog.viewer.choices.formula.Formula
import badlog.viewer.choices.formula.formulasOf

/**
 * The stages of a log: with its signals, with the Driver Station's log beside it, and with formulas. Each is made of the previous stage and
 * of one choice. If both are the same in the stages [before], it is taken from there. Selecting another field, for example, calculates no
 * formula again.
 *
 * @param read the content of the file.
 * @param name the name of its file.
 * @param vocabulary the names of its signals.
 * @param station the Driver Station's log of the same match that is shown with it; null for none.
 * @param definitions the definitions of the formulas calculated in it.
 * @param before the stages of the same log for other choices; null for none.
 * @param checkActive is called before each formula; an exception from it stops the work, and is passed on.
 */
internal class LogStages(
    private val read: LogView,
    name: String,
    private val vocabulary: SignalVocabulary,
    private val station: FoundStation<LogFile>?,
    private val definitions: List<String>,
    before: LogStages? = null,
    checkActive: () -> Unit = {},
) {
    private val own: LogView =
        before?.takeIf { it.read === read && it.vocabulary === vocabulary }?.own ?: read.withSignals(vocabulary, name)

    private val beside: StationOverlay? =
        if (before?.own === own && before.station == station) {
            before.beside
        } else {
            station?.let { StationOverlay(own, it.station, it.fit, vocabulary) }
        }

    /** The content of the file and of the [station]'s file. */
    val logged: LogView = beside?.both ?: own

    /** The view on which rules run. */
    val forRules: LogView get() = beside?.forRules ?: own

    /** The names of the topics from the [station]. */
    val stationTopics: Set<String> = beside?.stationTopics.orEmpty()

    /** The content of the files, and the topics of formulas. */
    val view: LogView

    /** The result of each of [definitions], in order. */
    val formulas: List<Formula>

    init {
        if (before?.logged === logged && before.definitions == definitions) {
            view = before.view
            formulas = before.formulas
        } else {
            val calculated = if (definitions.isEmpty()) null else calculate(checkActive)
            view = calculated?.view ?: logged
            formulas = calculated?.let { formulasOf(definitions, it) }.orEmpty()
        }
    }

    private fun calculate(checkActive: () -> Unit): ViewWithVirtualTopics {
        val draft = logged.beginVirtualTopics(definitions, vocabulary)
        do {
            checkActive()
        } while (draft.step())
        return draft.extended
    }
}
