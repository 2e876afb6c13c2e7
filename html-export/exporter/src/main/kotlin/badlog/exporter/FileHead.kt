package badlog.exporter

import badlog.core.bag.RecordingParser
import badlog.core.recording.Recording
import badlog.files.GzipReader
import badlog.formats.LOG_FORMATS
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.SignalVocabulary

/**
 * The facts in the first bytes of a file, before the rest is read.
 *
 * @property isGzip whether the file is compressed.
 * @property refusal the reason why the file is certainly not a recording, whatever follows; null if it may be one.
 */
internal class FileHead private constructor(val isGzip: Boolean, private val recording: Recording, val refusal: String?) {
    /** Whether the file consists of lines of text. */
    val hasLines: Boolean get() = recording.format.hasRows

    /** Returns the title of the match, according to these bytes or the file's [name]; null if it is unknown. */
    fun titleIn(name: String, signals: SignalVocabulary): String? = signals.matchOf(recording, name).title

    /** Returns whether this beginning of the file identifies the match without the file's name. */
    fun identifiesMatch(signals: SignalVocabulary): Boolean = titleIn(name = "", signals) != null

    companion object {
        /** The number of bytes that [of] needs; pass fewer only if the file is shorter. */
        const val BYTES = 1 shl 18

        /** Returns the facts in [bytes], the beginning of a file. */
        fun of(bytes: ByteArray): FileHead {
            val isGzip = GzipReader.isGzip(bytes)
            val parser = RecordingParser(LOG_FORMATS, keepSamples = false)
            if (isGzip) {
                GzipReader { inflated, size -> parser.accept(inflated, 0, size) }
                    .use { it.accept(bytes, 0, minOf(bytes.size, BYTES / 4)) }
            } else {
                parser.accept(bytes)
            }
            val recording = parser.finish()
            // Without rows, the parser rejected the bytes themselves. Text in rows may still have numbers later.
            return FileHead(isGzip, recording, recording.refusal.takeIf { parser.rowCount == 0 })
        }
    }
}
