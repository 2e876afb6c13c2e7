package badlog.report

import badlog.catalog.examine.UndefinedTopic

/**
 * Returns the messages about the virtual topics in [undefined], listed per log. Each definition has one, with all details if it failed for
 * every log.
 */
fun undefinedTexts(undefined: List<List<UndefinedTopic>>): List<String> {
    val ofDefinition = undefined.flatten().groupBy { it.definition }
    return ofDefinition.map { (definition, errors) ->
        val worst = errors.find { !it.isMissing } ?: mostHelpful(errors) { it.message }
        if (errors.size == undefined.size) worst.pointed else "“$definition” is not in ${count(errors.size, "log")}: ${worst.message}"
    }
}
