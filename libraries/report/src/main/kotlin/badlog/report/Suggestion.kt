package badlog.report

import badlog.expression.isSuggestion

/**
 * Returns the most helpful of [errors] for one mistake: the suggestion that most logs have, otherwise the first error.
 *
 * @param logsOf returns the number of logs with an error.
 */
internal fun <T> mostHelpful(errors: List<T>, logsOf: (T) -> Int = { 1 }, messageOf: (T) -> String): T {
    val suggestions = errors.filter { isSuggestion(messageOf(it)) }.groupBy(messageOf)
    return suggestions.values.maxByOrNull { alike -> alike.sumOf(logsOf) }?.first() ?: errors.first()
}

/** Returns the most helpful of the [refusals] with the error farthest into the question. Null if there are none. */
internal fun mostHelpful(refusals: List<Reply.NotAsked>): Reply.NotAsked? {
    val place = refusals.maxOfOrNull { it.place } ?: return null
    return mostHelpful(refusals.filter { it.place == place }) { it.message }
}
