package badlog.formats.wpilog

import badlog.formats.column.ColumnSource
import badlog.formats.column.SampleBlock
import badlog.formats.column.Timestamps

/**
 * A decoder for payloads of a type that the file itself describes. Payloads that come before their schema are held until it arrives; if
 * there are too many, only the latest ones.
 *
 * @param version returns a number that grows with every schema.
 * @param decoderNow returns the decoder for the type; null while a schema is missing, and if too few columns are left.
 */
internal class SchemaDecoder(
    private val source: ColumnSource,
    private val version: () -> Int,
    private val decoderNow: () -> PayloadDecoder?,
) : PayloadDecoder() {
    private class HeldRecord(val time: Double, val payload: ByteArray)

    // Not a deque, which would make every page larger by 2 kB.
    private var held = ArrayList<HeldRecord>()

    /** The number of first records of [held] that were skipped. */
    private var dropped = 0
    private var heldBytes = 0

    // The sizes of all payloads, once the payloads themselves need too much memory.
    private var sizes: SizeDecoder? = null
    private var triedVersion = -1
    private var decoder: PayloadDecoder? = null

    override var skippedCount = 0
        private set
    override val isUndecoded: Boolean get() = decoder?.isUndecoded == true
    override val timestamps: Timestamps get() = known().timestamps
    override val blocks: List<SampleBlock> get() = known().blocks

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (decoder == null && triedVersion != version()) tryToDecode()
        val known = decoder
        if (known != null) {
            known.accept(time, bytes, from, until)
            takeCounts(known)
            return
        }
        held += HeldRecord(time, bytes.copyOfRange(from, until))
        heldBytes += until - from + OVERHEAD
        sizes?.accept(time, bytes, from, until)
        if (heldBytes > MAX_HELD) dropFirst()
    }

    private fun dropFirst() {
        if (sizes == null) sizes = SizeDecoder(source).also { sizes -> for (record in held.drop(dropped)) sizes.accept(record) }
        while (heldBytes > MAX_HELD) {
            heldBytes -= held[dropped].payload.size + OVERHEAD
            dropped++
            skippedCount++
        }
        if (dropped > held.size / 2) keepOnly(held.drop(dropped))
    }

    private fun keepOnly(records: List<HeldRecord>) {
        held = ArrayList(records)
        dropped = 0
    }

    private fun PayloadDecoder.accept(record: HeldRecord) = accept(record.time, record.payload, 0, record.payload.size)

    override fun fits(bytes: ByteArray, from: Int, until: Int): Boolean = decoder?.fits(bytes, from, until) != false

    override fun finish() {
        if (decoder == null) tryToDecode()
        known()
    }

    private fun known(): PayloadDecoder = decoder ?: sizes?.also(::showSizes) ?: SizeDecoder(source).also(::decodeBy)

    private fun showSizes(sizes: SizeDecoder) {
        decoder = sizes
        keepOnly(emptyList())
        skippedCount = 0
    }

    private fun tryToDecode() {
        triedVersion = version()
        decoderNow()?.let(::decodeBy)
    }

    private fun decodeBy(known: PayloadDecoder) {
        decoder = known
        for (record in held.drop(dropped)) known.accept(record)
        keepOnly(emptyList())
        sizes = null
        takeCounts(known)
    }

    private fun takeCounts(known: PayloadDecoder) {
        badCount = known.badCount
        droppedValues = known.droppedValues
    }
}

private const val MAX_HELD = 1 shl 20

/** The estimated memory overhead of each held payload, in bytes, besides its content. */
private const val OVERHEAD = 64
