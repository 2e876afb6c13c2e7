package badlog.spark.lake

import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.season.lake.LakePieces
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/**
 * The settings of a lake that executors need.
 *
 * @property rules the rules for findings, as JSON.
 * @property hasSamples whether the lake has files of samples for each log besides the tables of all logs.
 */
internal data class LakeWork(val rules: String, val hasSamples: Boolean) : Serializable

/** The makers of lake pieces in this executor. Each kind of work has one, because starting DuckDB takes longer than the work on a log. */
internal object ExecutorPieces {
    private val made = ConcurrentHashMap<LakeWork, LakePieces>()

    init {
        Runtime.getRuntime().addShutdownHook(Thread { made.values.forEach(LakePieces::close) })
    }

    /** Returns the maker for [work]. */
    fun of(work: LakeWork): LakePieces = made.computeIfAbsent(work) {
        LakePieces(checkNotNull(RuleSet.fromJson(it.rules)) { "The rules cannot be read: ${it.rules}" }, it.hasSamples)
    }
}

/** Runs [work] with a temporary folder on this machine, and deletes the folder. */
internal fun <R> withScratchFolder(work: (Path) -> R): R {
    val folder = Files.createTempDirectory("badlog-spark")
    try {
        return work(folder)
    } finally {
        folder.toFile().deleteRecursively()
    }
}

private const val serialVersionUID = 1L
