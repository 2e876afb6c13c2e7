package badlog.text

/**
 * Gives each different text of a column a number from 0 on, finding a text it knows by its bytes, so that repeats cost no
 * object. Not safe for use by several threads.
 */
public class TextPool(private val decoder: TextDecoder) {
    private val texts = ArrayList<String>()
    private val encoded = ArrayList<ByteArray>()
    private var slots = IntArray(16) { FREE }

    /** Every different text, in the order of its number. */
    public val dictionary: List<String> get() = texts

    /** The number of the text whose bytes are given. */
    public fun idOf(bytes: ByteArray, from: Int, until: Int): Int {
        var slot = hash(bytes, from, until) and (slots.size - 1)
        while (slots[slot] != FREE) {
            if (isSame(encoded[slots[slot]], bytes, from, until)) return slots[slot]
            slot = (slot + 1) and (slots.size - 1)
        }
        val id = texts.size
        slots[slot] = id
        texts += decoder.decode(bytes, from, until)
        encoded += bytes.copyOfRange(from, until)
        if (texts.size * 2 > slots.size) grow()
        return id
    }

    /** The bytes of the text number [id]. */
    public fun bytesOf(id: Int): ByteArray = encoded[id]

    /** Forgets the text that was met last for the first time. */
    public fun forgetLast() {
        texts.removeAt(texts.lastIndex)
        val text = encoded.removeAt(encoded.lastIndex)
        var slot = hash(text, 0, text.size) and (slots.size - 1)
        while (slots[slot] != texts.size) slot = (slot + 1) and (slots.size - 1)
        // No text was put behind it, so none is searched for past its slot.
        slots[slot] = FREE
    }

    private fun grow() {
        slots = IntArray(slots.size * 2) { FREE }
        encoded.forEachIndexed { id, text ->
            var slot = hash(text, 0, text.size) and (slots.size - 1)
            while (slots[slot] != FREE) slot = (slot + 1) and (slots.size - 1)
            slots[slot] = id
        }
    }

    private fun hash(bytes: ByteArray, from: Int, until: Int): Int {
        var hash = until - from
        for (i in from until until) hash = hash * 31 + bytes[i]
        return hash xor (hash ushr 15)
    }

    private fun isSame(text: ByteArray, bytes: ByteArray, from: Int, until: Int): Boolean {
        if (text.size != until - from) return false
        for (i in text.indices) if (text[i] != bytes[from + i]) return false
        return true
    }

    private companion object {
        const val FREE = -1
    }
}
