package badlog.core.text

/**
 * Assigns a number, from 0 on, to each different text of a column. Known texts are found by their bytes, so repeated texts allocate
 * nothing. Not thread-safe.
 */
public class TextPool(private val decoder: TextDecoder) {
    private val texts = ArrayList<String>()
    private val encoded = ArrayList<ByteArray>()
    private var slots = IntArray(16) { FREE }

    /** Every different text, in the order of its number. */
    public val dictionary: List<String> get() = texts

    /** Returns the number of the text with these bytes. */
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

    /** Returns the bytes of text number [id]. */
    public fun bytesOf(id: Int): ByteArray = encoded[id]

    /** Removes the newest text. */
    public fun forgetLast() {
        texts.removeAt(texts.lastIndex)
        val text = encoded.removeAt(encoded.lastIndex)
        var slot = hash(text, 0, text.size) and (slots.size - 1)
        while (slots[slot] != texts.size) slot = (slot + 1) and (slots.size - 1)
        // No text was added after it, so no search goes past its slot.
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
}

private const val FREE = -1
