package badlog.report

import badlog.expression.ExpressionError
import badlog.expression.syntax.ExpressionErrorKind
import kotlinx.serialization.Serializable

/**
 * A virtual topic that could not be calculated for a log.
 *
 * @property definition its definition.
 * @property isMissing whether the log only lacks something that another log may have: a topic, or an x axis that
 * is a time.
 * @property message what is wrong, as a sentence.
 * @property pointed the message, the definition, and carets below it.
 */
@Serializable
class UndefinedTopic internal constructor(val definition: String, val isMissing: Boolean, val message: String, val pointed: String) {
    /** The topic of a definition that has this [error]. */
    constructor(error: ExpressionError) :
        this(error.text, error.kind in OF_THIS_LOG, error.message, error.pointed())

    private companion object {
        /** Another log may have the topic, or a time. */
        val OF_THIS_LOG = setOf(ExpressionErrorKind.UNKNOWN_TOPIC, ExpressionErrorKind.NO_TIME)
    }
}

/**
 * Returns the messages about the virtual topics in [undefined], listed per log: one for each definition, with all details
 * if it failed for every log.
 */
fun undefinedTexts(undefined: List<List<UndefinedTopic>>): List<String> {
    val ofDefinition = undefined.flatten().groupBy { it.definition }
    return ofDefinition.map { (definition, errors) ->
        val worst = errors.find { !it.isMissing } ?: errors[0]
        if (errors.size == undefined.size) worst.pointed else "“$definition” is not in ${count(errors.size, "log")}: ${worst.message}"
    }
}
