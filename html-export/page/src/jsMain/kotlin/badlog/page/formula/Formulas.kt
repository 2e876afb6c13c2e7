package badlog.page.formula

import badlog.core.analysis.Graph
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.expression.ExpressionError
import badlog.expression.VirtualTopic
import badlog.expression.signals.Vocabulary
import badlog.page.dom.LocalStorage
import badlog.signals.namesWith
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics
import badlog.viewer.choices.formula.Formula
import badlog.viewer.choices.formula.formulasOf
import badlog.viewer.choices.formula.keyOf
import badlog.viewer.choices.formula.usersOf
import badlog.viewer.choices.mergedWith

/**
 * The topics of the page that are calculated from others: those it was made with, and those of its reader, which the browser
 * remembers for the file.
 *
 * @property logged the recording as it was logged.
 * @property signals the vocabulary of signals; formulas may use them.
 * @param given the definitions that the page was made with.
 * @param fileKey identifies the file.
 */
internal class Formulas(val logged: LogView, val signals: SignalVocabulary, given: List<String>, fileKey: String) {
    private val key = "formulas:$fileKey"
    private val ofPage = given
    private val persons = remembered().toMutableList()

    /** The person's definitions as this tab last read or stored them. */
    private var known = remembered()
    private val formulas = ArrayList<Formula>()

    /** The recording with the topics that could be calculated. */
    var view: LogView = logged
        private set

    private var named: Pair<LogView, Vocabulary>? = null

    /** The names of the recording's topics and the calculated ones in formulas. Worked out on demand, because it takes a while. */
    val vocabulary: Vocabulary
        get() {
            val known = named?.takeIf { it.first === view } ?: (view to view.namesWith(signals).vocabulary).also { named = it }
            return known.second
        }

    /** Why some of the given or remembered formulas could not be calculated. */
    val errors: List<ExpressionError>

    /** The recording with the topics of the definitions that the page was made with. */
    val given: LogView

    init {
        val ofPage = extend(given)
        this.given = view
        errors = ofPage + extend(persons)
    }

    /** The person's definitions and those of links, in order of arrival. */
    val own: List<String> get() = persons

    /** Returns whether [definition] is one of the page, or of the person. */
    fun has(definition: String): Boolean = formulas.any { it.definition == definition }

    /** The names of the calculated topics. */
    val names: Set<String> get() = formulas.mapNotNullTo(HashSet()) { it.topic?.name }

    /** Returns the formula that calculates [graph], or null if it was logged. */
    fun formulaOf(graph: Graph): String? = formulas.find { it.topic?.name == graph.name }?.definition

    /** Returns the name of the topic that [definition], one of [own], defines; null if it defines none. */
    fun nameOf(definition: String): String? = formulas.find { it.definition == definition }?.topic?.name

    /** The results of all definitions, in the order in which they may use each other. */
    val all: List<Formula> get() = formulas

    /** Returns why [text] is not a valid definition, as a replacement of [replaced] unless that is null; null if it is valid. */
    fun mistakeIn(text: String, replaced: String? = null): ExpressionError? {
        val known = if (replaced == null) {
            vocabulary
        } else {
            viewOf(persons - replaced - formulas.usersOf(replaced).toSet()).namesWith(signals).vocabulary
        }
        return VirtualTopic.parse(text, known) as? ExpressionError
    }

    /** Calculates [definition], which must have no mistake. If [isRemembered], it is remembered with all others. Returns its graph. */
    fun add(definition: String, isRemembered: Boolean = true): Graph {
        extend(listOf(definition))
        persons += definition
        if (isRemembered) remember()
        return graphOf(definition)
    }

    /** Remembers all of [own], and what other tabs have changed meanwhile, which this one calculates when it is opened again. */
    fun remember() {
        val merged = own.mergedWith(remembered(), known, key = ::keyOf)
        known = own.toList()
        LocalStorage[key] = merged.joinToString("\n")
    }

    private fun remembered() = LocalStorage[key].orEmpty().split('\n').filter { it.isNotBlank() && it !in ofPage }

    /** Removes [definition], which no other one uses. */
    fun remove(definition: String) = change(persons - definition)

    /** Calculates [definition], which must have no mistake, in place of [replaced], and recalculates those that use it. */
    fun replace(replaced: String, definition: String) = change(persons.map { if (it == replaced) definition else it })

    /** Returns the graph of [definition], which must define one. */
    fun graphOf(definition: String): Graph {
        val name = nameOf(definition)
        return view.folders.flatMap { it.graphs }.first { it.name == name }
    }

    /** Returns another log as it was logged in a file called [fileName], with the same names for signals. */
    fun viewOf(recording: Recording, fileName: String): LogView = LogView.of(recording).withSignals(signals, fileName)

    /** Returns [other] with the same formulas, as far as it has their topics. */
    fun extended(other: LogView): LogView =
        (ofPage + persons).let { if (it.isEmpty()) other else other.withVirtualTopics(it, signals).view }

    private fun viewOf(definitions: List<String>) = if (definitions.isEmpty()) given else given.withVirtualTopics(definitions, signals).view

    private fun change(definitions: List<String>) {
        formulas.removeAll { it.definition in persons }
        persons.clear()
        persons += definitions
        remember()
        view = given
        extend(persons)
    }

    private fun extend(definitions: List<String>): List<ExpressionError> {
        if (definitions.isEmpty()) return emptyList()
        val extended = view.withVirtualTopics(definitions, signals)
        view = extended.view
        formulas += formulasOf(definitions, extended)
        return extended.errors
    }
}
