package badlog.window.formula

import androidx.compose.runtime.Stable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.TextFieldValue
import badlog.expression.ExpressionError
import badlog.expression.ParsedVirtualTopic
import badlog.expression.VirtualTopic
import badlog.expression.signals.Vocabulary
import badlog.signals.namesWith
import badlog.viewer.choices.formula.Suggestions
import badlog.viewer.choices.formula.TypedRemark
import badlog.viewer.choices.formula.nameIn
import badlog.viewer.choices.formula.nameInExpression
import badlog.viewer.choices.formula.reasonToKeep
import badlog.viewer.choices.formula.whileTyping
import badlog.viewer.state.BoardAction
import badlog.viewer.state.GraphChange
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.task.Notices

/**
 * The formulas of the window: definitions of topics that are calculated from others. A formula may use other formulas only if they come
 * before it. Use it only on the window's thread.
 */
internal class FormulaStore(private val current: CurrentRecording, private val board: GraphBoard, private val notices: Notices) {
    /** The definitions of the formulas. */
    var definitions: List<String> by mutableStateOf(emptyList())
        private set

    /** The dialog of the formula being written, or null. */
    var sheet: FormulaSheet? by mutableStateOf(null)
        private set

    /** The formulas that a person removed: files beside the logs do not bring them back. */
    @Volatile
    private var removed = emptySet<String>()

    /** Opens the dialog for a new formula that multiplies [names] of the open recording; does nothing without a recording. */
    fun write(names: List<String> = emptyList()) {
        val open = current.recording ?: return
        val vocabulary = vocabularyFor(open, definition = null)
        val start = if (names.isEmpty()) "" else " = " + names.joinToString(" * ") { nameInExpression(it, vocabulary) }
        sheet = FormulaSheet(start = start)
    }

    /** Opens the dialog for [definition]. */
    fun edit(definition: String) {
        sheet = FormulaSheet(definition)
    }

    /** Closes the dialog; its text is lost. */
    fun closeSheet() {
        sheet = null
    }

    /** Adds [definition] of the topic [name], and draws it. */
    fun add(definition: String, name: String) {
        removed = removed - definition
        definitions = (definitions + definition).distinct()
        board.send(GraphChange.Add(listOf(name)))
    }

    /** Replaces [before] by [definition] of the topic [name], also in graphs. */
    fun replace(before: String, definition: String, name: String) {
        removed = removed + before
        definitions = definitions.map { if (it == before) definition else it }.distinct()
        nameIn(before)?.let { board.send(BoardAction.Rename(it, name)) }
    }

    /** Removes [definition], also from the graphs, and returns true; false, with a notice, if other formulas need it. */
    fun remove(definition: String): Boolean {
        current.recording?.formulas?.reasonToKeep(definition)?.let { reason ->
            notices.complain(reason)
            return false
        }
        removed = removed + definition
        definitions = definitions - definition
        nameIn(definition)?.let { board.send(BoardAction.Forget(setOf(it))) }
        return true
    }

    /** Returns whether [name] belongs to a formula that is not calculated in [open] yet. */
    fun isAwaited(name: String, open: OpenRecording): Boolean = definitions.any { it !in open.definitions && nameIn(it) == name }

    /** Returns the formulas, and those [others] that define other topics and were not removed by a person. Can be called on any thread. */
    fun with(others: List<String>): List<String> {
        val names = definitions.mapTo(HashSet(), ::nameIn)
        return definitions + others.filter { it !in removed && nameIn(it) !in names }
    }

    /** Replaces all formulas by [definitions]. */
    fun replaceAll(definitions: List<String>) {
        this.definitions = definitions
    }
}

/**
 * The dialog in which a person writes a formula.
 *
 * @property before the definition being changed; null for a new one.
 * @property start the initial text.
 */
internal data class FormulaSheet(val before: String? = null, val start: String = before.orEmpty())

/**
 * Returns the names that [definition] may use in [open]: the topics, and the formulas before it. If [definition] is null, it returns all of
 * them.
 */
internal fun vocabularyFor(open: OpenRecording, definition: String?): Vocabulary {
    val earlier = open.formulas.takeWhile { it.definition != definition }.mapNotNull { it.topic?.signal }
    return earlier.fold(open.logged.namesWith(open.vocabulary).vocabulary) { names, topic -> names.with(topic) }
}

/**
 * A definition while it is being typed.
 *
 * @param start the initial text.
 * @param vocabulary the names it may use.
 */
@Stable
internal class FormulaWriter(start: String, private val vocabulary: Vocabulary) {
    private var typed by mutableStateOf(TextFieldValue(start, TextRange(if (start.startsWith(" = ")) 0 else start.length)))

    /** The content of the field. A definition is one line. */
    var field: TextFieldValue
        get() = typed
        set(value) {
            val hasChanged = value.text != typed.text
            typed = value.copy(text = value.text.map { if (it.isISOControl()) ' ' else it }.joinToString(""))
            if (hasChanged) marked = NONE
        }

    /** The index of the suggested name selected with the keyboard; [NONE] for none. */
    var marked by mutableStateOf(NONE)
        private set

    private val parsed: ParsedVirtualTopic by derivedStateOf { VirtualTopic.parse(typed.text, vocabulary) }

    /** The topic that it defines; null while it is not valid. */
    val topic: VirtualTopic? get() = parsed as? VirtualTopic

    /** The mistake in the definition; null if there is none, or nothing was typed. */
    val error: ExpressionError? get() = (parsed as? ExpressionError)?.takeIf { typed.text.isNotBlank() }

    /** The remark on that mistake. */
    val remark: TypedRemark? get() = error?.whileTyping()

    /** The suggested names at the text cursor. */
    val suggestions: Suggestions by derivedStateOf { Suggestions.of(typed.text, typed.selection.end, vocabulary) }

    /** Selects the suggested name [steps] further down. */
    fun mark(steps: Int) {
        val count = suggestions.names.size
        if (count > 0) marked = (marked + steps).coerceIn(0, count - 1)
    }

    /** Replaces the typed part by the suggested name [index]. */
    fun take(index: Int) {
        val name = nameInExpression(suggestions.names.getOrNull(index) ?: return, vocabulary)
        val text = typed.text
        val (from, until) = suggestions.from to suggestions.until
        typed = TextFieldValue(text.substring(0, from) + name + text.substring(until), TextRange(from + name.length))
        marked = NONE
    }

    companion object {
        const val NONE = -1
    }
}
