package badlog.catalog.examine

import badlog.expression.ExpressionError
import badlog.expression.syntax.ExpressionErrorKind
import kotlinx.serialization.Serializable

/**
 * A virtual topic that could not be calculated for a log.
 *
 * @property definition its definition.
 * @property isMissing whether the log only lacks something that another log may have: a topic, or a time as x axis.
 * @property message the error, as a sentence.
 * @property pointed the message, the definition, and carets below it.
 */
@Serializable
class UndefinedTopic internal constructor(val definition: String, val isMissing: Boolean, val message: String, val pointed: String) {
    /** Creates the topic for a definition with this [error]. */
    constructor(error: ExpressionError) :
        this(error.text, error.kind in OF_THIS_LOG, error.message, error.pointed())

    private companion object {
        /** The errors that depend on the log: another one may have the topic, or a time. */
        val OF_THIS_LOG = setOf(ExpressionErrorKind.UNKNOWN_TOPIC, ExpressionErrorKind.NO_TIME)
    }
}
