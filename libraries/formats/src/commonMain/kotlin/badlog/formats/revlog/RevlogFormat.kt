package badlog.formats.revlog

import badlog.core.recording.LogFormat
import badlog.core.recording.LogParser
import badlog.core.recording.Recording
import badlog.formats.wpilog.WpilogParser

/** The `.revlog` of REV's devices, read as the WPILOG that [RevlogConversion] makes of it. */
public object RevlogFormat : LogFormat {
    override val id: String get() = "revlog"

    override val title: String get() = "REV log"

    override val endings: List<String> get() = listOf(".revlog")

    override val hasRecords: Boolean get() = true

    override val signatureSize: Int get() = SIGNATURE_SIZE

    /** Returns whether the bytes begin with a record of such a file, which has no signature. */
    override fun matches(bytes: ByteArray, size: Int): Boolean = RevlogHead.at(bytes, 0, size).let { it != null && it !== RevlogHead.MORE }

    override fun parser(keepSamples: Boolean): LogParser = RevlogParser(WpilogParser(keepSamples))

    private const val SIGNATURE_SIZE = 17
}

private class RevlogParser(private val wpilog: WpilogParser) : LogParser {
    private val conversion = RevlogConversion { bytes, size -> wpilog.accept(bytes, 0, size) }

    override val rowCount: Int get() = wpilog.rowCount
    override var maxRows: Int by wpilog::maxRows
    override val isFull: Boolean get() = wpilog.isFull

    override fun accept(bytes: ByteArray, from: Int, until: Int) = conversion.accept(bytes, from, until)

    override fun finish(): Recording {
        val problems = conversion.finish()
        val read = wpilog.finish()
        return read.copy(format = RevlogFormat, problems = problems + read.problems)
    }
}
