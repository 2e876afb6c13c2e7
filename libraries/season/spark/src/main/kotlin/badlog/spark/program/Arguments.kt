package badlog.spark.program

/** Thrown for invalid arguments; the message describes the mistake. */
internal class UsageException(override val message: String) : Exception(message)

/**
 * The arguments after the name of a job.
 *
 * @property named the arguments that are not options, in their order.
 */
internal class Arguments private constructor(val named: List<String>, private val options: Map<String, String>) {
    /** Returns the value of the option [name]; null if it is not given. */
    fun option(name: String): String? = options[name]

    /** Returns the value of the option [name], which is required. */
    fun required(name: String): String = options[name] ?: throw UsageException("$name is missing.")

    /** Returns the maximum size of files, in bytes. */
    fun maxBytes(): Long {
        val text = options[MAX_SIZE] ?: return Long.MAX_VALUE
        val megabytes = text.toLongOrNull()?.takeIf { it in 1..MAX_MEGABYTES }
            ?: throw UsageException("$MAX_SIZE $text: it is a number of MB, such as 500.")
        return megabytes shl MEGA
    }

    internal companion object {
        const val OUT = "--out"
        const val RULES = "--rules"
        const val FORMAT = "--format"
        const val MAX_SIZE = "--max-size"
        private const val MEGA = 20
        private const val MAX_MEGABYTES = 1L shl 40

        /** Returns the arguments of a job in [words]. Each of its options, [known], is followed by its value. */
        fun of(words: List<String>, known: Set<String>): Arguments {
            val named = ArrayList<String>()
            val options = HashMap<String, String>()
            var i = 0
            while (i < words.size) {
                val word = words[i++]
                when {
                    !word.startsWith("--") -> named += word
                    word !in known -> throw UsageException("$word is not an option here; there are ${known.sorted().joinToString()}.")
                    i == words.size -> throw UsageException("$word has no value.")
                    else -> options[word] = words[i++]
                }
            }
            return Arguments(named, options)
        }
    }
}
