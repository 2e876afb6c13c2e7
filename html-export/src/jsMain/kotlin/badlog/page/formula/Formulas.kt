package badlog.page.formula

import badlog.analysis.Graph
import badlog.analysis.LogView
import badlog.expression.ExpressionError
import badlog.expression.VirtualTopic
import badlog.expression.signals.Vocabulary
import badlog.page.dom.LocalStorage
import badlog.plot.formula.Formula
import badlog.plot.formula.formulasOf
import badlog.rules.namesWith
import badlog.rules.signal.SignalVocabulary
import badlog.rules.withVirtualTopics

/**
 * The topics of the page that are calculated from others: those it came with, and those of the person who reads it, which the
 * browser remembers for the file.
 *
 * @param logged the recording as it is.
 * @param signals what topics are called; formulas may name them.
 * @param given the definitions that the page came with.
 * @param fileKey identifies the file.
 */
internal class Formulas(logged: LogView, private val signals: SignalVocabulary, given: List<String>, fileKey: String) {
    private val key = "formulas:$fileKey"
    private val remembered = LocalStorage[key].orEmpty().split('\n').filter { it.isNotBlank() && it !in given }.toMutableList()
    private val formulas = ArrayList<Formula>()

    /** The recording with the topics that could be calculated. */
    var view: LogView = logged
        private set

    /** What the recording's topics and the calculated ones are called in formulas. */
    var vocabulary: Vocabulary = logged.namesWith(signals).vocabulary
        private set

    /** Why some of what was given or remembered could not be calculated. */
    val errors: List<ExpressionError>

    /** The recording with the topics of the definitions that the page came with. */
    val given: LogView

    init {
        val ofPage = extend(given)
        this.given = view
        errors = ofPage + extend(remembered)
    }

    /** The person's definitions, in the order in which they were made. */
    val own: List<String> get() = remembered

    /** The formula that [graph] is calculated by, or null when it was logged. */
    fun formulaOf(graph: Graph): String? = formulas.find { it.topic?.name == graph.name }?.definition

    /** The name of the topic that [definition], one of [own], makes; null when it makes none. */
    fun nameOf(definition: String): String? = formulas.find { it.definition == definition }?.topic?.name

    /** Why [text] is not a definition, or null when it is one. */
    fun mistakeIn(text: String): ExpressionError? = VirtualTopic.parse(text, vocabulary) as? ExpressionError

    /** Calculates [definition], which has no mistake, and remembers it. Returns its graph. */
    fun add(definition: String): Graph {
        extend(listOf(definition))
        remembered += definition
        remember()
        val name = formulas.last().topic?.name
        return view.folders.flatMap { it.graphs }.first { it.name == name }
    }

    /** Forgets [definition]. What was calculated from it stays until the page is opened again. */
    fun remove(definition: String) {
        formulas.removeAll { it.definition == definition }
        remembered -= definition
        remember()
    }

    private fun extend(definitions: List<String>): List<ExpressionError> {
        if (definitions.isEmpty()) return emptyList()
        val extended = view.withVirtualTopics(definitions, signals)
        view = extended.view
        vocabulary = view.namesWith(signals).vocabulary
        formulas += formulasOf(definitions, extended)
        return extended.errors
    }

    private fun remember() {
        LocalStorage[key] = remembered.joinToString("\n")
    }
}
