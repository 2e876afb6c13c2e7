package badlog.viewer.formula

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
import badlog.plot.formula.Suggestions
import badlog.plot.formula.nameInExpression

/**
 * A definition while it is typed.
 *
 * @param start the text to begin with.
 * @param vocabulary the names it may use.
 */
@Stable
internal class FormulaWriter(start: String, private val vocabulary: Vocabulary) {
    private var typed by mutableStateOf(TextFieldValue(start, TextRange(if (start.startsWith(" = ")) 0 else start.length)))

    /** What stands in the field. A definition is one line. */
    var field: TextFieldValue
        get() = typed
        set(value) {
            val hasChanged = value.text != typed.text
            typed = value.copy(text = value.text.map { if (it.isISOControl()) ' ' else it }.joinToString(""))
            if (hasChanged) marked = NONE
        }

    /** Which of the suggested names the keyboard stands on; [NONE] for none. */
    var marked by mutableStateOf(NONE)
        private set

    private val parsed: ParsedVirtualTopic by derivedStateOf { VirtualTopic.parse(typed.text, vocabulary) }

    /** The topic that it defines; null while it is none. */
    val topic: VirtualTopic? get() = parsed as? VirtualTopic

    /** What is wrong; null when nothing is, or nothing was typed. */
    val error: ExpressionError? get() = (parsed as? ExpressionError)?.takeIf { typed.text.isNotBlank() }

    /** The names that may be meant at the text cursor. */
    val suggestions: Suggestions by derivedStateOf { Suggestions.of(typed.text, typed.selection.end, vocabulary) }

    /** Marks the suggested name that is [steps] further down. */
    fun mark(steps: Int) {
        val count = suggestions.names.size
        if (count > 0) marked = (marked + steps).coerceIn(0, count - 1)
    }

    /** Puts the suggested name [index] where a part of it was typed. */
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
