package badlog.wpilog

/** Payloads with one value: the [columns] get it. */
internal abstract class SingleDecoder(source: ColumnSource, paths: List<String>) : PayloadDecoder() {
    protected val columns = source.columns(paths)
    override val clock = Clock(source.keepsSamples)
    override val blocks = listOf(SampleBlock(columns, clock))
}

/** Payloads of a fixed [layout]: a number, or a struct. */
internal class LayoutDecoder(source: ColumnSource, private val layout: ValueLayout) :
    SingleDecoder(source, layout.leaves.map { it.path }) {
    private val leaves = layout.leaves.toTypedArray()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        if (until - from != layout.width) {
            badCount++
            return
        }
        for (i in leaves.indices) leaves[i].read(bytes, from, columns[i])
        clock.add(time)
    }
}

/** Payloads that are a text. */
internal class TextPayloadDecoder(source: ColumnSource) : SingleDecoder(source, listOf("")) {
    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        columns[0].addText(bytes, from, until)
        clock.add(time)
    }
}

/** Payloads that nothing here understands: how many bytes each has. */
internal class SizeDecoder(source: ColumnSource) : SingleDecoder(source, listOf("")) {
    override val isUndecoded: Boolean get() = true

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        columns[0].addNumber((until - from).toDouble())
        clock.add(time)
    }
}

/** Payloads for which there is no column left: they are only counted. */
internal class NoDecoder : PayloadDecoder() {
    override val clock = Clock(false)
    override val blocks get() = emptyList<SampleBlock>()

    override fun accept(time: Double, bytes: ByteArray, from: Int, until: Int) {
        droppedValues++
    }
}
