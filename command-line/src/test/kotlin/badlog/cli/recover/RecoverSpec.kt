package badlog.cli.recover

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.ROOT
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.gzip
import badlog.cli.names
import badlog.cli.with
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readBytes
import kotlin.io.path.readText

@Tags("InCheck")
class RecoverSpec : FunSpec({
    /** The clean log of [log] is whole, has all of its rows and topics, and recovering it again changes nothing. */
    fun shouldBecomeWhole(log: Path, folder: Path) {
        val clean = folder / "clean/"
        val ended = badlog("recover", log, "-o", "$clean/", "--force")
        val before = readRecording(log, LOG_FORMATS)
        if (ended.code == ExitCode.NOTHING) {
            (before.rowCount == 0) shouldBe true
            return
        }
        ended.code shouldBe if (before.isSalvaged) ExitCode.SALVAGED else ExitCode.WHOLE
        val after = readRecording(clean / log.fileName.toString(), LOG_FORMATS)
        after.isSalvaged shouldBe false
        after.rowCount shouldBe before.rowCount
        after.values shouldBe before.values
        after.topics.map { it.name } shouldBe before.topics.map { it.name }
        after.topics.map { topic -> topic.samples.filterNot { it.isNaN() } } shouldBe
            before.topics.map { topic -> topic.samples.filterNot { it.isNaN() } }
        val again = folder / "again-${log.fileName}"
        badlog("recover", clean / log.fileName.toString(), "-o", again, "--force").code shouldBe ExitCode.WHOLE
        again.readBytes().toList() shouldBe (clean / log.fileName.toString()).readBytes().toList()
    }

    for (log in (ROOT / "core/conformance").listDirectoryEntries("*.bag").sorted()) {
        test("the conformance case ${log.fileName} becomes whole") { inFolder { shouldBecomeWhole(log, it) } }
    }

    test("a sample cut anywhere becomes whole") {
        val whole = (SAMPLES / "practice.bag").readBytes()
        inFolder { folder ->
            checkAll(25, Arb.int(0, whole.size)) { size ->
                shouldBecomeWhole(folder.with("cut.bag", whole.copyOf(size)), folder)
            }
        }
    }

    test("a log with random damage becomes whole, or is refused") {
        inFolder { folder ->
            checkAll(Arb.int(0, BAG.length), Arb.byteArray(Arb.int(0, 12), Arb.byte())) { at, noise ->
                val bytes = BAG.encodeToByteArray()
                val damaged = bytes.copyOf(at) + noise + bytes.copyOfRange(minOf(bytes.size, at + noise.size / 2), bytes.size)
                val ended = badlog("recover", folder.with("a.bag", damaged), "-o", folder / "b.bag", "--force")
                val before = readRecording(folder / "a.bag", LOG_FORMATS)
                when {
                    ended.code != ExitCode.NOTHING -> readRecording(folder / "b.bag", LOG_FORMATS).isSalvaged shouldBe false
                    before.isReadable && before.rowCount > 0 -> ended.err shouldContain "reads differently"
                }
            }
        }
    }

    test("losses are counted in rows, cells and bytes") {
        inFolder { folder ->
            val ended = badlogJson("recover", folder.with("a.bag", CUT_BAG))
            ended.code shouldBe ExitCode.SALVAGED
            val lost = ended.json.single().getValue("lost").jsonObject
            lost.getValue("rows").jsonPrimitive.int shouldBe 1
            lost.getValue("cells").jsonPrimitive.int shouldBe 2
            lost.getValue("bytes").jsonPrimitive.int shouldBe CUT_BAG.lines().last().length
            readRecording(folder / "a.recovered.bag", LOG_FORMATS).rowCount shouldBe 4
        }
    }

    test("a whole log is copied only with --out") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("recover", log).out shouldContain "whole; nothing to recover"
            folder.names() shouldContainExactly listOf("a.bag")
            badlog("recover", log, "-o", folder / "b.bag").code shouldBe ExitCode.WHOLE
            (folder / "b.bag").readText() shouldBe BAG
        }
    }

    test("a folder is mirrored, compressed logs as such") {
        inFolder { folder ->
            val logs = (folder / "logs").createDirectory()
            logs.with("a.bag", CUT_BAG)
            val gz = gzip(BAG)
            logs.with("deep/b.bag.gz", gz.copyOf(gz.size - 12))
            badlog("recover", logs, "-o", folder / "clean").code shouldBe ExitCode.SALVAGED
            (folder / "clean").names() shouldContainExactly listOf("a.bag", "deep")
            readRecording(folder / "clean/deep/b.bag.gz", LOG_FORMATS).problems.none { it.severity.name == "ERROR" } shouldBe true
            (folder / "clean/deep/b.bag.gz").readBytes()[0] shouldBe 0x1f
        }
    }
})
