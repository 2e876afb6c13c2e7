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
import badlog.viewer.choices.formula.Suggestions
import badlog.viewer.choices.formula.TypedRemark
import badlog.viewer.choices.formula.nameInExpression
import badlog.viewer.choices.formula.whileTyping

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
