package badlog.lib

import badlog.core.bag.BagHeader
import badlog.core.bag.BagValue
import badlog.core.bag.RowWriter
import badlog.core.recording.Value

/** The topics and values of a log during setup, each with a unique name. Guarded by the log's lock. */
internal class Namespace {
    private val names = HashSet<String>()
    private val values = ArrayList<BagValue>()
    val topics = ArrayList<Topic>()

    /**
     * Adds [topic].
     *
     * @throws DuplicateNameException if its name is taken.
     */
    fun add(topic: Topic) {
        claim(topic.name)
        topics.add(topic)
    }

    /**
     * Adds the value [name] with [text].
     *
     * @throws DuplicateNameException if [name] is taken.
     */
    fun addValue(name: String, text: String) {
        claim(name)
        values.add(BagValue(Value(name, text)))
    }

    /** Returns the first two lines of the file. */
    fun headerLines(): ByteArray {
        val lines = RowWriter().header(BagHeader(topics.map { it.description }, values), asOriginal = true)
        return lines.bytes.copyOf(lines.size)
    }

    private fun claim(name: String) {
        if (!names.add(name)) {
            throw DuplicateNameException(
                "There is already a topic or value \"$name\" in this log. Give one of the two another name.",
            )
        }
        val odd = name.firstOrNull { !it.isLetterOrDigit() && it != ' ' && it != '_' && it != '/' } ?: return
        StandardError.print("The name \"$name\" has the character '$odd'; letters, digits, spaces, _ and / are safer.")
    }
}
