package badlog.replay

/** Names of a recording as NetworkTables has them: `/Folder/Name`, each once, all below [prefix] if there is one. */
internal class TopicNames(prefix: String) {
    private val start = prefix.trim('/').let { if (it.isEmpty()) "/" else "/$it/" }
    private val given = HashSet<String>()

    /** A name that no other call gives. What a log took from NetworkTables, `NT:/…`, gets its name of then back. */
    fun nameOf(name: String): String {
        val wanted = start + name.removePrefix("NT:").trimStart('/')
        var free = wanted
        var copy = 2
        while (!given.add(free)) free = "$wanted (${copy++})"
        return free
    }
}
