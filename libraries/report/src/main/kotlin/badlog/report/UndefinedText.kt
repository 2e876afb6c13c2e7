package badlog.report

import badlog.catalog.examine.UndefinedTopic

/**
 * Returns one message for each definition in [undefined], which lists the failed virtual topics of each log. The message has all details if
 * the definition failed for every log.
 */
fun undefinedTexts(undefined: List<List<UndefinedTopic>>): List<String> {
    val ofDefinition = undefined.flatten().groupBy { it.definition }
    return ofDefinition.map { (definition, errors) ->
        val worst = errors.find { !it.isMissing } ?: mostHelpful(errors) { it.message }
        if (errors.size == undefined.size) worst.pointed else "“$definition” is not in ${count(errors.size, "log")}: ${worst.message}"
    }
}
