package badlog.spark.lake

import badlog.rules.RuleSet
import badlog.rules.fromJson
import badlog.season.lake.LakePieces
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/** What makes the pieces of lakes in this executor: one for each set of rules, as starting DuckDB takes longer than a log. */
internal object ExecutorPieces {
    private val made = ConcurrentHashMap<String, LakePieces>()

    init {
        Runtime.getRuntime().addShutdownHook(Thread { made.values.forEach(LakePieces::close) })
    }

    /** The one that looks for what the rules [json] say. */
    fun of(json: String): LakePieces =
        made.computeIfAbsent(json) { LakePieces(checkNotNull(RuleSet.fromJson(it)) { "The rules cannot be read: $it" }) }
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
