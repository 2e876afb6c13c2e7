package badlog.cli.output

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.wpilog
import badlog.files.inFolder
import badlog.formats.wpilog.record.RecordEntry
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes

/** Logs of a season's robot. They are not part of the project, so the tests run where they are. */
private val REAL_LOGS = System.getenv("BADLOG_REAL_LOGS")?.let { Path.of(it).listDirectoryEntries("*.wpilog").sorted() }.orEmpty()

private fun heldIn(entry: RecordEntry): List<String> = List(entry.size) { "${entry.time(it)} ${entry.payload(it).toList()}" }

private fun heldIn(log: Path): Map<String, List<String>> = recordsOf(log).entries.associate { "${it.name} ${it.type}" to heldIn(it) }

class RecordFileSpec : FunSpec({
    val where = { _: Any? -> if (REAL_LOGS.isNotEmpty()) Enabled.enabled else Enabled.disabled("the logs are not on this machine") }

    test("parts of a season's logs have the same records, and merged again all of them").config(enabledOrReasonIf = where) {
        for (log in REAL_LOGS) {
            inFolder { folder ->
                val whole = heldIn(log)
                val times = whole.values.flatten().map { it.substringBefore(' ').toDouble() }
                val middle = times.sorted()[times.size / 2]
                badlog("cut", log, "--to", middle, "-o", folder / "a.wpilog")
                badlog("cut", log, "--from", middle, "-o", folder / "b.wpilog")
                val (first, second) = listOf("a", "b").map { heldIn(folder / "$it.wpilog") }
                for ((entry, records) in whole) {
                    val (before, after) = records.partition { it.substringBefore(' ').toDouble() <= middle }
                    first.getValue(entry) shouldContainExactly before
                    // One more holds where it begins.
                    second.getValue(entry) shouldContainAll after
                    (second.getValue(entry).size - after.size <= records.size - after.size) shouldBe true
                }
                badlog("merge", folder / "a.wpilog", folder / "b.wpilog", "-o", folder / "m.wpilog", "--append").out shouldNotContain "renamed"
                val merged = heldIn(folder / "m.wpilog")
                for ((entry, records) in whole) merged.getValue(entry) shouldContainAll records
            }
        }
    }

    test("a season's logs keep their values without repetitions, and all records when recovered").config(enabledOrReasonIf = where) {
        for (log in REAL_LOGS) {
            inFolder { folder ->
                badlog("convert", log, "--changes-only", "-o", folder / "c.wpilog")
                val changes = heldIn(folder / "c.wpilog")
                for ((entry, records) in heldIn(log)) {
                    val kept = changes.getValue(entry)
                    records shouldContainAll kept
                    fun payloads(held: List<String>) = held.map { it.substringAfter(' ') }
                    fun runs(list: List<String>) = list.filterIndexed { i, it -> i == 0 || list[i - 1] != it }
                    runs(payloads(kept)) shouldBe runs(payloads(records))
                }
                badlog("recover", log, "-o", folder / "r.wpilog")
                (folder / "r.wpilog").readBytes().size shouldBeGreaterThan 12
                heldIn(folder / "r.wpilog") shouldBe heldIn(log)
            }
        }
    }

    test("whole numbers beyond 2^53, raw bytes and metadata survive a cut, a merge and a calculated topic") {
        inFolder { folder ->
            val log = folder.wpilog(
                "a.wpilog",
                listOf(
                    Logged("Ticks", "int64", "{\"unit\":\"1\"}", listOf(1.0 to 1e18, 3.0 to 1e18 + 1024)),
                    Logged("Photo", "raw", "lens", listOf(2.0 to "bytes")),
                    Logged("Pose", "struct:Pose2d", "", listOf(2.0 to "16 bytes, or so..")),
                ),
            )
            val whole = heldIn(log)
            badlogJson("cut", log, "--from", "1", "-o", folder / "b.wpilog").code shouldBe ExitCode.WHOLE
            heldIn(folder / "b.wpilog") - "Part string" shouldBe whole
            badlog("merge", folder / "b.wpilog", log, "-o", folder / "m.wpilog").code shouldBe ExitCode.WHOLE
            heldIn(folder / "m.wpilog") shouldBe whole
            badlog("convert", log, "--topic", "Half = Ticks / 2", "-o", folder / "v.wpilog").code shouldBe ExitCode.WHOLE
            val calculated = heldIn(folder / "v.wpilog")
            (calculated - calculated.keys.filter { it.startsWith("Half ") }.toSet()) shouldBe whole
            calculated.keys.map { it.substringBefore(' ') } shouldContain "Half"
        }
    }
})
