package badlog.spark.lake

import badlog.season.lake.LakeLayout
import badlog.season.lake.RegisteredLog
import badlog.spark.storage.RemoteFolder
import org.apache.spark.api.java.function.FlatMapFunction

/** Reads the entries for logs from a file of the table of matches in [lake]. */
internal class ReadRegister(private val lake: RemoteFolder, private val work: LakeWork) : FlatMapFunction<String, RegisteredLog> {
    override fun call(file: String): Iterator<RegisteredLog> = withScratchFolder { scratch ->
        lake.fetch(file, scratch.resolve(file))
        ExecutorPieces.of(work).registered(scratch).iterator()
    }

    internal companion object {
        private const val serialVersionUID = 1L

        /** Returns whether [file], relative to a lake, is a file of the table of matches. */
        fun isMatches(file: String): Boolean =
            file.startsWith(LakeLayout.MATCHES + "/") && file.endsWith("/" + LakeLayout.MATCHES + LakeLayout.ENDING)
    }
}
