package badlog.cli.lake

import badlog.cli.BAG
import badlog.cli.IF_ENDED_GENTLY
import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.cli.endGently
import badlog.cli.plugin.SeasonService
import badlog.cli.plugin.javaCommand
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.booleans.shouldBeTrue
import io.kotest.matchers.shouldBe
import java.nio.file.Files
import java.nio.file.Path
import java.util.ServiceLoader
import java.util.concurrent.TimeUnit
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.time.Duration.Companion.minutes

/** So many that a program is still at work when it has written the tables several times. */
private const val MANY = 800

/** So many that a program is still at work when it has written some. */
private const val SOME = 200

@Tags("InCheck")
class KilledLakeSpec : FunSpec({
    fun makeLogs(folder: Path, count: Int) {
        for (number in 1..count) {
            val event = """{"name":"Event Name","value":"Event ${number % 3}"},"""
            (folder / "logs").with("q$number.bag", BAG.replace(""""values":[""", """"values":[$event""").replace("\"42\"", "\"$number\""))
        }
    }

    /** Runs the installed program until [isTime], and ends it by [end]. Returns false if it was faster. */
    suspend fun isStopped(folder: Path, isTime: (Path) -> Boolean, end: (Process) -> Unit): Boolean {
        val command = javaCommand("lake", "${folder / "logs"}", "--out", "${folder / "lake"}")
        val temporary = Files.createDirectories(folder / "temporary")
        val process = ProcessBuilder(command.take(1) + "-Djava.io.tmpdir=$temporary" + command.drop(1)).redirectErrorStream(true).start()
        process.outputStream.close()
        eventually(5.minutes) { (isTime(folder / "lake") || !process.isAlive).shouldBeTrue() }
        end(process)
        process.waitFor(5, TimeUnit.MINUTES) shouldBe true
        return process.exitValue() != 0
    }

    fun filesIn(folder: Path): Int = if (!folder.exists()) 0 else Files.walk(folder).use { all -> all.filter { Files.isRegularFile(it) }.count().toInt() }

    /** All tables of [lake], each a line per row. */
    fun tablesOf(lake: Path): Map<String, List<String>> = ServiceLoader.load(SeasonService::class.java).first().open(lake, null).use { session ->
        session.tables().associate { table ->
            table.name to buildList {
                session.query("SELECT * FROM ${table.name} ORDER BY ALL", {}) { add("$it") }
            }
        }
    }

    fun readable(lake: Path): Int {
        val tables = tablesOf(lake)
        val logs = tables.getValue("matches").size
        // Each of the logs that are there is there whole.
        tables.getValue("samples").size shouldBe logs * BAG.lines().drop(2).count { it.isNotEmpty() }
        return logs
    }

    fun drafts(folder: Path): Long = Files.walk(folder / "lake").use { all -> all.filter { it.fileName.toString().endsWith(".part") }.count() }

    fun isUndisturbed(folder: Path) {
        badlog("lake", folder / "logs", "--out", folder / "lake").code shouldBe ExitCode.WHOLE
        badlog("lake", folder / "logs", "--out", folder / "other").code shouldBe ExitCode.WHOLE
        tablesOf(folder / "lake") shouldBe tablesOf(folder / "other")
        drafts(folder) shouldBe 0
    }

    /** Repeats [stop] until it ended a program in the middle: on a busy machine, a program may finish before that. */
    suspend fun untilInTheMiddle(folder: Path, stop: suspend () -> Boolean) {
        for (attempt in 1..20) {
            if (stop()) return
            (folder / "lake").toFile().deleteRecursively()
        }
        error("Each program had finished before it could be ended.")
    }

    test("a lake can be read after repeated kills, and is complete after the last run") {
        inFolder { folder ->
            makeLogs(folder, MANY)
            untilInTheMiddle(folder) {
                isStopped(folder, { filesIn(it / "samples") >= 30 }) { it.destroyForcibly() } &&
                    readable(folder / "lake") < MANY &&
                    isStopped(folder, { filesIn(it / "matches") >= 1 }) { it.destroyForcibly() } &&
                    readable(folder / "lake") < MANY
            }
            isUndisturbed(folder)
        }
    }

    test("Ctrl+C leaves a lake with whole files only, and the next run does the rest")
        .config(enabledOrReasonIf = { IF_ENDED_GENTLY }) {
            inFolder { folder ->
                makeLogs(folder, SOME)
                untilInTheMiddle(folder) {
                    isStopped(folder, { filesIn(it / "samples") >= 30 }, ::endGently)
                }
                drafts(folder) shouldBe 0
                (folder / "temporary").toFile().list().orEmpty().filter { it.startsWith("badlog-duckdb") } shouldBe emptyList()
                // The written logs are in the tables.
                readable(folder / "lake") shouldBe filesIn(folder / "lake/samples")
                isUndisturbed(folder)
            }
        }
})
