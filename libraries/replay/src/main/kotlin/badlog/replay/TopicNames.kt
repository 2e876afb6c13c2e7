package badlog.replay

import badlog.text.UniqueNames

/** Names of a recording as NetworkTables has them: `/Folder/Name`, each once, all below [prefix] if there is one. */
internal class TopicNames(prefix: String) {
    private val start = prefix.trim('/').let { if (it.isEmpty()) "/" else "/$it/" }
    private val names = UniqueNames()

    /** A name that no other call gives. What a log took from NetworkTables, `NT:/…`, gets its name of then back. */
    fun nameOf(name: String): String = names.give(start + name.removePrefix("NT:").trimStart('/'))
}
