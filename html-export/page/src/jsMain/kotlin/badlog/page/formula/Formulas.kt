package badlog.page.formula

import badlog.core.analysis.Graph
import badlog.core.analysis.LogView
import badlog.core.recording.Recording
import badlog.expression.ExpressionError
import badlog.expression.ViewWithVirtualTopics
import badlog.expression.VirtualTopic
import badlog.expression.VirtualTopicsDraft
import badlog.expression.signals.Vocabulary
import badlog.expression.vocabularyWith
import badlog.expression.withoutTopics
import badlog.page.dom.LocalStorage
import badlog.page.dom.sliceMillis
import badlog.signals.beginVirtualTopics
import badlog.signals.namesWith
import badlog.signals.vocabulary.SignalVocabulary
import badlog.signals.withSignals
import badlog.signals.withVirtualTopics
import badlog.viewer.choices.formula.Formula
import badlog.viewer.choices.formula.formulasOf
import badlog.viewer.choices.formula.keyOf
import badlog.viewer.choices.formula.usersOf
import badlog.viewer.choices.mergedWith
import kotlinx.browser.window

/**
 * The calculated topics of the page: its own, and its reader's, which the browser remembers for the file. Each calculation is done
 * in slices. Before a second one begins, the first is finished at once.
 *
 * @property logged the recording as it was logged.
 * @property signals the vocabulary of signals; formulas may use them.
 * @param ofPage the definitions that the page was made with.
 * @param fileKey identifies the file.
 */
internal class Formulas(val logged: LogView, val signals: SignalVocabulary, private val ofPage: List<String>, fileKey: String) {
    private val key = "formulas:$fileKey"
    private val persons = remembered().toMutableList()

    /** The reader's definitions as this tab last read or stored them. */
    private var known = remembered()
    private val formulas = ArrayList<Formula>()
    private var running: FormulaSlices? = null

    /** Called with the share of the work done while a calculation takes longer than a slice. Called with 1 at its end. */
    var onProgress: (Double) -> Unit = {}

    /** Called if a calculation fails, for example because memory runs out. */
    var onFailure: (Throwable) -> Unit = {}

    /** The recording with the calculated topics. */
    var view: LogView = logged
        private set

    private var named: Pair<LogView, Vocabulary>? = null

    /** The names of recorded and calculated topics in formulas. Computed on demand, because it takes a while. */
    val vocabulary: Vocabulary
        get() {
            val known = named?.takeIf { it.first === view } ?: (view to view.namesWith(signals).vocabulary).also { named = it }
            return known.second
        }

    /** The reasons why given or remembered formulas could not be calculated. */
    var errors: List<ExpressionError> = emptyList()
        private set

    /** The recording with the topics of the definitions that the page was made with. */
    var given: LogView = logged
        private set

    private val givenNames by lazy { given.namesWith(signals) }

    /** Calculates the page's, the reader's and the [linked] definitions where possible, then calls [done]. */
    fun start(linked: List<String>, done: () -> Unit) = extend(ofPage) { ofPage ->
        given = view
        extend(persons) { own ->
            errors = ofPage + own
            addAll(linked.filterNot(::has), isRemembered = false) { done() }
        }
    }

    /** Finishes a calculation at once. */
    fun finish() {
        while (running?.isOver == false) running?.finish()
    }

    /** Cancels a calculation and drops its results. */
    fun cancel() {
        running?.cancel()
    }

    /** The definitions of the reader and of links, in the order in which they were added. */
    val own: List<String> get() = persons

    /** Returns whether [definition] belongs to the page or the reader. */
    fun has(definition: String): Boolean = formulas.any { it.definition == definition }

    /** The names of the calculated topics. */
    val names: Set<String> get() = formulas.mapNotNullTo(HashSet()) { it.topic?.name }

    /** Returns the definition that calculates [graph]; null if the graph was logged. */
    fun formulaOf(graph: Graph): String? = formulas.find { it.topic?.name == graph.name }?.definition

    /** Returns the name of the topic that [definition] defines; null if it defines none. */
    fun nameOf(definition: String): String? = formulas.find { it.definition == definition }?.topic?.name

    /** The results of all definitions, each after those that it uses. */
    val all: List<Formula> get() = formulas

    /**
     * Returns the mistake in the definition [text]; null if it is valid. [replaced] is the definition that it will replace; null if it is
     * new.
     */
    fun mistakeIn(text: String, replaced: String? = null): ExpressionError? {
        val known = when (replaced) {
            null -> vocabulary
            else -> vocabularyWith(givenNames, persons - formulas.usersOf(replaced).toSet() - replaced)
        }
        return VirtualTopic.parse(text, known) as? ExpressionError
    }

    /**
     * Calculates the valid [definitions], then calls [then] with the mistakes in the others. If [isRemembered], also stores all of [own].
     */
    fun addAll(definitions: List<String>, isRemembered: Boolean, then: (List<ExpressionError>) -> Unit) = extend(definitions) { mistakes ->
        formulas.removeAll { it.topic == null && it.definition in definitions }
        persons += definitions.filter(::has)
        if (isRemembered) remember()
        then(mistakes)
    }

    /** Stores all of [own], merged with changes of other tabs, which this tab calculates only when it is opened again. */
    fun remember() {
        val merged = own.mergedWith(remembered(), known, key = ::keyOf)
        known = own.toList()
        LocalStorage[key] = merged.joinToString("\n")
    }

    private fun remembered() = LocalStorage[key].orEmpty().split('\n').filter { it.isNotBlank() && it !in ofPage }

    /** Removes [definition], which no other definition uses. */
    fun remove(definition: String) {
        finish()
        view = viewWithout(listOf(definition))
        forget(listOf(definition))
        remember()
    }

    /** Calculates [definition], which must be valid, in place of [replaced], and the definitions that use it; then calls [then]. */
    fun replace(replaced: String, definition: String, then: () -> Unit) {
        finish()
        val users = formulas.usersOf(replaced)
        extend(listOf(definition) + users, { viewWithout(users + replaced) }, { forget(users + replaced) }) {
            persons += listOf(definition) + users
            remember()
            then()
        }
    }

    /** Returns the graph of [definition], which must define one. */
    fun graphOf(definition: String): Graph {
        val name = nameOf(definition)
        return view.folders.flatMap { it.graphs }.first { it.name == name }
    }

    /** Returns the view of another log, from a file named [fileName], with the same names for signals. */
    fun viewOf(recording: Recording, fileName: String): LogView = LogView.of(recording).withSignals(signals, fileName)

    /** Returns [other] with the same formulas, as far as it has their topics. */
    fun extended(other: LogView): LogView =
        (ofPage + persons).let { if (it.isEmpty()) other else other.withVirtualTopics(it, signals).view }

    private fun viewWithout(definitions: List<String>) = view.withoutTopics(definitions.mapNotNullTo(HashSet(), ::nameOf))

    private fun forget(definitions: List<String>) {
        formulas.removeAll { it.definition in definitions }
        persons.removeAll(definitions)
    }

    /** Calculates [definitions] from the topics [from]. Then calls [before], and [done] with the mistakes. */
    private fun extend(
        definitions: List<String>,
        from: () -> LogView = { view },
        before: () -> Unit = {},
        done: (List<ExpressionError>) -> Unit,
    ) {
        finish()
        if (definitions.isEmpty()) return done(emptyList())
        val slices = FormulaSlices(from().beginVirtualTopics(definitions, signals), { onProgress(it) }, { onFailure(it) }) { extended ->
            onProgress(1.0)
            before()
            view = extended.view
            formulas += formulasOf(definitions, extended)
            done(extended.errors)
        }
        running = slices
        slices.next()
    }
}

/**
 * Calculates the topics of [draft] in slices, so that the page stays responsive. Work that fits one slice is done at once.
 *
 * @param onProgress called after each slice but the last, with the share of the work that is done.
 * @param onFailure called if there is not enough memory, or for an unexpected error.
 * @param done called at the end, unless the work is canceled.
 */
internal class FormulaSlices(
    private val draft: VirtualTopicsDraft,
    private val onProgress: (Double) -> Unit,
    private val onFailure: (Throwable) -> Unit,
    private val done: (ViewWithVirtualTopics) -> Unit,
) {
    /** Whether it is done, canceled or failed. */
    var isOver = false
        private set

    /** Calculates until the time of one slice is over; a timer then starts the next slice. */
    fun next() {
        if (isOver) return
        val end = window.performance.now() + sliceMillis(SLICE)
        work { window.performance.now() < end }
    }

    /** Calculates the rest at once. */
    fun finish() {
        if (!isOver) work { true }
    }

    /** Stops the work for good; none of the functions is called afterwards. */
    fun cancel() {
        isOver = true
    }

    private fun work(mayGoOn: () -> Boolean) {
        try {
            while (draft.step()) {
                if (mayGoOn()) continue
                onProgress(draft.share)
                window.setTimeout(::next, 0)
                return
            }
            isOver = true
            done(draft.extended)
        } catch (problem: Throwable) {
            isOver = true
            onFailure(problem)
        }
    }
}

/** The milliseconds of a slice, which fits into a frame. */
private const val SLICE = 16
