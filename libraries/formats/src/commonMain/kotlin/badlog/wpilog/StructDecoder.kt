package badlog.wpilog

import badlog.column.ColumnSource
import badlog.column.SampleBlock
import badlog.column.Timestamps

/**
 * Payloads of the struct [name], or of arrays of it. Those that come before its schema wait for it, as far as there is room.
 */
internal class StructDecoder(
    private val source: ColumnSource,
    private val schemas: StructSchemas,
    private val name: String,
    private val isArray: Boolean,
) : PayloadDecoder() {
    private class Held(val time: Double, val payload: ByteArray)

    private val held = ArrayList<Held>()
    private var heldBytes = 0
    private var triedVersion = -1
    private var decoder: PayloadDecoder? = null

    override val isUndecoded: Boolean get() = decoder?.isUndecoded == true
    override val timestamps: Timestamps get() = known().timestamps
    override val blocks: List<SampleBlock> get() = known().blocks

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (decoder == null && triedVersion != schemas.version) tryToDecode()
        val known = decoder
        if (known != null) {
            known.accept(time, bytes, from, until)
            takeCounts(known)
            return
        }
        held += Held(time, bytes.copyOfRange(from, until))
        heldBytes += until - from + OVERHEAD
        if (heldBytes > MAX_HELD) decodeBy(SizeDecoder(source))
    }

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = decoder?.fits(bytes, from, until) != false

    override fun finish() {
        if (decoder == null) tryToDecode()
        known()
    }

    private fun known(): PayloadDecoder = decoder ?: SizeDecoder(source).also(::decodeBy)

    private fun tryToDecode() {
        triedVersion = schemas.version
        val layout = schemas.layoutOf(name) ?: return
        if (!source.hasRoomFor(layout.leaves.size)) return
        decodeBy(if (isArray) LayoutArrayDecoder(source, layout) else LayoutDecoder(source, layout))
    }

    private fun decodeBy(known: PayloadDecoder) {
        decoder = known
        for (record in held) known.accept(record.time, record.payload, 0, record.payload.size)
        held.clear()
        takeCounts(known)
    }

    private fun takeCounts(known: PayloadDecoder) {
        badCount = known.badCount
        droppedValues = known.droppedValues
    }

    private companion object {
        const val MAX_HELD = 1 shl 20

        /** What holding a payload costs beside its bytes. */
        const val OVERHEAD = 64
    }
}
