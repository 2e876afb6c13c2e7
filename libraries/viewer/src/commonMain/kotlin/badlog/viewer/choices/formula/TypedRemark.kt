package badlog.viewer.choices.formula

import badlog.expression.ExpressionError

/**
 * The remark on a definition while a person types it.
 *
 * @property isError whether it is a mistake that more typing cannot fix; otherwise it is a hint.
 */
class TypedRemark(val text: String, val isError: Boolean)

/** Returns the remark on this mistake. A mistake at the end of the text may disappear with the next letter. */
fun ExpressionError.whileTyping(): TypedRemark = when {
    until < text.trimEnd().length -> TypedRemark(message, isError = true)
    isFunctionAlone -> TypedRemark("Type on for a name, or “(” for the function ${text.substring(from, until)}.", isError = false)
    else -> TypedRemark(message, isError = false)
}
