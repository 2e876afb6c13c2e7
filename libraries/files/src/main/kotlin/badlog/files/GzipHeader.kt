package badlog.files

/** Finds the end of a gzip member's header (RFC 1952), byte by byte. */
internal class GzipHeader {
    /** Whether the header continues, has ended, or is invalid. */
    enum class State { MORE, DONE, NONE }

    private var position = 0
    private var flags = 0
    private var part = FIXED
    private var extraLeft = 0

    /** Accepts the next [byte], 0 to 255. Call it only after [State.MORE]. */
    fun accept(byte: Int): State {
        val at = position++
        when (part) {
            FIXED -> {
                if (at < MAGIC.size && byte != MAGIC[at]) return State.NONE
                if (at == FLAGS_AT) flags = byte
                if (at < FIXED_SIZE - 1) return State.MORE
            }

            EXTRA -> {
                if (at == 0) extraLeft = byte
                if (at == 1) extraLeft += byte shl 8
                if (at < 1 || at < 1 + extraLeft) return State.MORE
            }

            NAME, COMMENT -> if (byte != 0) return State.MORE

            CHECK -> if (at == 0) return State.MORE
        }
        return nextPart()
    }

    private fun nextPart(): State {
        position = 0
        do part++ while (part <= CHECK && flags and FLAG_OF[part] == 0)
        return if (part > CHECK) State.DONE else State.MORE
    }

    private companion object {
        // The parts in order; all but the first are present only if their flag is set.
        const val FIXED = 0
        const val EXTRA = 1
        const val NAME = 2
        const val COMMENT = 3
        const val CHECK = 4
        val FLAG_OF = intArrayOf(0, 4, 8, 16, 2)

        /** The first bytes: the signature, then deflate, the only compression method. */
        val MAGIC = intArrayOf(0x1F, 0x8B, 8)
        const val FLAGS_AT = 3
        const val FIXED_SIZE = 10
    }
}
