package badlog.wpilog

import badlog.recording.LogFormat
import badlog.recording.LogParser

/** The WPILOG, the log of WPILib's DataLog. */
public object WpilogFormat : LogFormat {
    override val signatureSize: Int get() = RecordSplitter.MAGIC.length

    override fun matches(bytes: ByteArray, size: Int): Boolean =
        size >= signatureSize && RecordSplitter.MAGIC.indices.all { bytes[it].toInt() == RecordSplitter.MAGIC[it].code }

    override fun parser(keepSamples: Boolean): LogParser = WpilogParser(keepSamples)
}
