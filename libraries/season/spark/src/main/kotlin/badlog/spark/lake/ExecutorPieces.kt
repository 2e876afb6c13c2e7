package badlog.spark.lake

import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.season.lake.LakePieces
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/**
 * What is to be made of logs.
 *
 * @property rules what findings are looked for, as JSON.
 * @property hasSamples whether the lake has a file for each log, besides the tables of all logs.
 */
internal data class LakeWork(val rules: String, val hasSamples: Boolean) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

/** What makes the pieces of lakes in this executor: one for each kind of work, as starting DuckDB takes longer than a log. */
internal object ExecutorPieces {
    private val made = ConcurrentHashMap<LakeWork, LakePieces>()

    init {
        Runtime.getRuntime().addShutdownHook(Thread { made.values.forEach(LakePieces::close) })
    }

    /** Returns the one for [work]. */
    fun of(work: LakeWork): LakePieces = made.computeIfAbsent(work) {
        LakePieces(checkNotNull(RuleSet.fromJson(it.rules)) { "The rules cannot be read: ${it.rules}" }, it.hasSamples)
    }
}

/** Does [work] with a folder of this machine that goes afterwards. */
internal fun <R> inScratch(work: (Path) -> R): R {
    val folder = Files.createTempDirectory("badlog-spark")
    try {
        return work(folder)
    } finally {
        folder.toFile().deleteRecursively()
    }
}
