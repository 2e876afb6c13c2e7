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
 * @property logged the recording as it is.
 * @param signals what topics are called; formulas may name them.
 * @param given the definitions that the page came with.
 * @param fileKey identifies the file.
 */
internal class Formulas(val logged: LogView, private val signals: SignalVocabulary, given: List<String>, fileKey: String) {
    private val key = "formulas:$fileKey"
    private val persons = LocalStorage[key].orEmpty().split('\n').filter { it.isNotBlank() && it !in given }.toMutableList()
    private val formulas = ArrayList<Formula>()

    /** The recording with the topics that could be calculated. */
    var view: LogView = logged
        private set

    private var named: Pair<LogView, Vocabulary>? = null

    /** What the recording's topics and the calculated ones are called in formulas. Found out when somebody asks: that takes a while. */
    val vocabulary: Vocabulary
        get() {
            val known = named?.takeIf { it.first === view } ?: (view to view.namesWith(signals).vocabulary).also { named = it }
            return known.second
        }

    /** Why some of what was given or remembered could not be calculated. */
    val errors: List<ExpressionError>

    /** The recording with the topics of the definitions that the page came with. */
    val given: LogView

    init {
        val ofPage = extend(given)
        this.given = view
        errors = ofPage + extend(persons)
    }

    /** The person's definitions and those of links, in the order in which they came. */
    val own: List<String> get() = persons

    /** Whether [definition] is one of the page, or of the person. */
    fun has(definition: String): Boolean = formulas.any { it.definition == definition }

    /** The names of the topics that are calculated. */
    val names: Set<String> get() = formulas.mapNotNullTo(HashSet()) { it.topic?.name }

    /** The formula that [graph] is calculated by, or null when it was logged. */
    fun formulaOf(graph: Graph): String? = formulas.find { it.topic?.name == graph.name }?.definition

    /** The name of the topic that [definition], one of [own], makes; null when it makes none. */
    fun nameOf(definition: String): String? = formulas.find { it.definition == definition }?.topic?.name

    /** Those of [own] that cannot be calculated without the topic of [definition], in their order. */
    fun usersOf(definition: String): List<String> {
        val needed = hashSetOf(nameOf(definition) ?: return emptyList())
        return formulas.filter { formula ->
            val topic = formula.topic
            topic != null && topic.expression.topics.any { it in needed } && needed.add(topic.name)
        }.map { it.definition }
    }

    /** Why [text] is not a definition, in the place of [replaced] where that is not null; null when it is one. */
    fun mistakeIn(text: String, replaced: String? = null): ExpressionError? {
        val known = if (replaced ==
            null
        ) {
            vocabulary
        } else {
            viewOf(persons - replaced - usersOf(replaced).toSet()).namesWith(signals).vocabulary
        }
        return VirtualTopic.parse(text, known) as? ExpressionError
    }

    /** Calculates [definition], which has no mistake, and remembers it, if it [isRemembered], with all others. Returns its graph. */
    fun add(definition: String, isRemembered: Boolean = true): Graph {
        extend(listOf(definition))
        persons += definition
        if (isRemembered) remember()
        return graphOf(definition)
    }

    /** Remembers all of [own]. */
    fun remember() {
        LocalStorage[key] = own.joinToString("\n")
    }

    /** Forgets [definition], which no other uses. */
    fun remove(definition: String) = change(persons - definition)

    /** Calculates [definition], which has no mistake, in the place of [replaced], and those that use it again. */
    fun replace(replaced: String, definition: String) = change(persons.map { if (it == replaced) definition else it })

    /** The graph of [definition], which makes one. */
    fun graphOf(definition: String): Graph {
        val name = nameOf(definition)
        return view.folders.flatMap { it.graphs }.first { it.name == name }
    }

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
