package badlog.viewer.choices.formula

/** Returns the definitions of the formulas that need the topic of [definition], directly or through others, in order. */
fun List<Formula>.usersOf(definition: String): List<String> {
    val needed = hashSetOf(find { it.definition == definition }?.topic?.name ?: return emptyList())
    return filter { formula ->
        val topic = formula.topic
        topic != null && topic.expression.topics.any { it in needed } && needed.add(topic.name)
    }.map { it.definition }
}

/** Returns the reason why [definition] cannot be removed, as a sentence; null if it can. */
fun List<Formula>.reasonToKeep(definition: String): String? = usersOf(definition).sentence("it; remove that first")

/** Returns the reason why [definition] cannot be replaced by [replacement] with another name, as a sentence; null if it can. */
fun List<Formula>.reasonToKeepName(definition: String, replacement: String): String? =
    if (nameIn(definition) == nameIn(replacement)) null else usersOf(definition).sentence("this name; change that first")

private fun List<String>.sentence(end: String): String? = when (size) {
    0 -> null
    1 -> "“${single()}” needs $end."
    else -> "${joinToString { "“$it”" }} need $end."
}
