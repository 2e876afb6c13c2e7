package badlog.spark.cluster

import badlog.files.inFolder
import badlog.season.matchBag
import badlog.season.put
import badlog.season.refresh
import badlog.spark.SPARK_HOME
import badlog.spark.SPARK_IS_HERE
import badlog.spark.shouldEqualLake
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.readText

private const val LOGS = 150
private const val ROWS = 4_000

/** Spark's messages about a lost worker. */
private val LOSS = Regex("Lost executor|Removed executor|worker lost", RegexOption.IGNORE_CASE)

class KilledWorkerSpec : FunSpec({
    test("a cluster that loses a worker makes the same lake as one process, row by row").config(enabledOrReasonIf = SPARK_IS_HERE) {
        inFolder { folder ->
            val logs = folder / "logs"
            for (match in 1..LOGS) {
                val volts = DoubleArray(ROWS) { row -> 12.0 + (row * match % 97) / 100.0 }
                logs.put("day ${match % 4}/q$match.bag", matchBag(match, *volts, event = "Event ${match % 3}"))
            }
            logs.put("cut.bag", matchBag(200, 12.0, 11.0, event = "Event 1") + "0.2")
            logs.put("notes.bag", ByteArray(5000) { (it * 31).toByte() })
            refresh(logs, folder / "expected")
            // On a busy machine, a job may finish before its first check.
            val isInTheMiddle = (1..5).any { attempt ->
                val lake = folder / "lake$attempt"
                val place = (folder / "cluster$attempt").createDirectories()
                LocalCluster(SPARK_HOME!!, place).use { cluster ->
                    val job = cluster.submit(System.getProperty("badlog.spark.jar"), "lake", "$logs", "--out", "$lake")
                    val written = awaitWritten(lake / "samples", job)
                    cluster.killWorker()
                    withClue({ cluster.log("job").takeLast(4_000) }) {
                        job.waitFor(15, TimeUnit.MINUTES) shouldBe true
                        job.exitValue() shouldBe 0
                    }
                    val output = (place / "job.out").readText()
                    output shouldContain "${LOGS + 1} written (1 with data missing), 1 not in the lake"
                    output shouldContain "${logs / "notes.bag"}: "
                    lake shouldEqualLake folder / "expected"
                    written in 1 until LOGS && LOSS in cluster.log("job")
                }
            }
            isInTheMiddle shouldBe true
        }
    }
})

/** Waits until some logs are in [samples]. Returns their number. */
private fun awaitWritten(samples: Path, job: Process): Int {
    while (job.isAlive) {
        val written = if (Files.isDirectory(samples)) filesIn(samples) else 0
        if (written >= LOGS / 10) return written
        Thread.sleep(20)
    }
    return 0
}

/** Counts files, which may appear and disappear meanwhile. */
private fun filesIn(folder: Path): Int = folder.toFile().walk().count { it.name.endsWith(".parquet") }
