package badlog.cli.recover

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.with
import badlog.cli.wpilog
import badlog.cli.wpilogBytes
import badlog.core.recording.Recording
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
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayOutputStream
import java.nio.file.Path
import java.util.zip.GZIPOutputStream
import kotlin.io.path.div
import kotlin.io.path.exists
import kotlin.io.path.readBytes

/** All that has a record in the log that is made of [recording]. It is text, because NaN does not equal NaN. */
private fun contentOf(recording: Recording): List<String> = recording.values.map { "$it" } + recording.topics.map { topic ->
    val texts = List(topic.texts.size) { "${topic.texts.rows[it]}: ${topic.texts[it]}" }
    "${topic.name} ${topic.type} ${topic.metadata} ${topic.unit} ${topic.attributes} ${topic.times?.toList()} ${topic.samples.toList()} $texts"
}

private val LOG = listOf(
    Logged("Speed", "double", "{\"unit\":\"m/s\",\"note\":1}", List(60) { it / 50.0 to it * 1.25 }),
    Logged("Small", "float", "no JSON", List(20) { it / 20.0 to it / 8.0 }),
    Logged("Count", "int64", "", List(20) { it / 20.0 to it * 1e6 }),
    Logged("DS:enabled", "boolean", "", listOf(0.1 to false, 0.5 to true)),
    Logged("Mode", "string", "{\"source\":\"x\"}", List(20) { it / 20.0 to "mode ${it % 3}" }),
    Logged("messages", "string", "", List(12) { it / 10.0 to "message $it, \"so\"" }),
    Logged("config", "json", "", listOf(0.2 to "{\"a\":[1,2]}")),
)

/** Later than all else, so that its record is the last, of 17 and 5 bytes. */
private val PHOTO = Logged("photo", "raw", "", listOf(9.0 to "bytes"))

@Tags("InCheck")
class RecoverWpilogSpec : FunSpec({
    fun lost(json: JsonObject, what: String) = json.getValue("lost").jsonObject.getValue(what).jsonPrimitive.int

    /** The clean log of [log] is whole and holds all that could be read; recovering that again changes nothing. */
    fun shouldBecomeWhole(log: Path, folder: Path) {
        val clean = folder / "clean.wpilog"
        val ended = badlog("recover", log, "-o", clean, "--force")
        if (ended.code == ExitCode.NOTHING) return
        val before = readRecording(log, LOG_FORMATS)
        ended.code shouldBe if (before.isSalvaged) ExitCode.SALVAGED else ExitCode.WHOLE
        val after = readRecording(clean, LOG_FORMATS)
        after.isSalvaged shouldBe false
        contentOf(after) shouldBe contentOf(before)
        badlog("recover", clean, "-o", folder / "again.wpilog", "--force").code shouldBe ExitCode.WHOLE
        (folder / "again.wpilog").readBytes().toList() shouldBe clean.readBytes().toList()
    }

    test("a log cut anywhere becomes whole, with the types, metadata and times of all that it held") {
        val whole = wpilogBytes(LOG)
        inFolder { folder ->
            checkAll(150, Arb.int(0, whole.size)) { size -> shouldBecomeWhole(folder.with("cut.wpilog", whole.copyOf(size)), folder) }
        }
    }

    test("a log with random damage becomes whole, or is refused") {
        val whole = wpilogBytes(LOG)
        inFolder { folder ->
            checkAll(Arb.int(0, whole.size), Arb.byteArray(Arb.int(0, 12), Arb.byte())) { at, noise ->
                val damaged = whole.copyOf(at) + noise + whole.copyOfRange(minOf(whole.size, at + noise.size / 2), whole.size)
                val ended = badlog("recover", folder.with("a.wpilog", damaged), "-o", folder / "b.wpilog", "--force")
                if (ended.code != ExitCode.NOTHING) readRecording(folder / "b.wpilog", LOG_FORMATS).isSalvaged shouldBe false
            }
        }
    }

    test("losses are counted in records and bytes") {
        inFolder { folder ->
            val whole = wpilogBytes(LOG)
            val cut = badlogJson("recover", folder.with("a.wpilog", whole.copyOf(whole.size - 3))).json.single()
            lost(cut, "cells") shouldBe 1
            // The last record is a double's: a head of 17 bytes, and 8 more.
            lost(cut, "bytes") shouldBe 17 + 8 - 3
            cut.getValue("samples").jsonPrimitive.int shouldBe 134
            cut.getValue("lostMore").jsonPrimitive.boolean shouldBe false
            badlog("recover", folder / "a.wpilog", "--force").out shouldContain "kept 134 samples, lost 1 record, 22 bytes"

            val nonsense = folder.with("b.wpilog", whole + ByteArray(40) { -1 })
            lost(badlogJson("recover", nonsense).json.single(), "bytes") shouldBe 40

            val unknown = byteArrayOf(0, 99, 1, 5, 1) + byteArrayOf(0, 1, 3, 5, 1, 2, 3)
            val inside = folder.with("c.wpilog", whole.copyOf(whole.size - 25) + unknown + whole.takeLast(25))
            val mixed = badlogJson("recover", inside).json.single()
            lost(mixed, "cells") shouldBe 2
            mixed.getValue("samples").jsonPrimitive.int shouldBe 135
        }
    }

    test("a cut compressed log is salvaged, stays compressed, and has an unknown loss") {
        inFolder { folder ->
            val out = ByteArrayOutputStream()
            GZIPOutputStream(out).use { it.write(wpilogBytes(LOG)) }
            val log = folder.with("a.wpilog.gz", out.toByteArray().copyOf(out.size() / 2))
            val json = badlogJson("recover", log).json.single()
            json.getValue("lostMore").jsonPrimitive.boolean shouldBe true
            (folder / "a.recovered.wpilog.gz").readBytes()[0] shouldBe 0x1f
            readRecording(folder / "a.recovered.wpilog.gz", LOG_FORMATS).isSalvaged shouldBe false
        }
    }

    test("a whole log is left alone, or copied to the byte") {
        inFolder { folder ->
            val log = folder.wpilog("a.wpilog", LOG + PHOTO)
            badlog("recover", log).out shouldContain "whole; nothing to recover"
            folder.names() shouldContainExactly listOf("a.wpilog")
            badlog("recover", log, "-o", folder / "b.wpilog").out shouldContain "lost nothing"
            (folder / "b.wpilog").readBytes().toList() shouldBe log.readBytes().toList()
            badlog("recover", log, "-o", folder / "c.wpilog.gz").code shouldBe ExitCode.WHOLE
            badlog("recover", folder / "c.wpilog.gz", "-o", folder / "d.wpilog").code shouldBe ExitCode.WHOLE
            (folder / "d.wpilog").readBytes().toList() shouldBe log.readBytes().toList()
        }
    }

    test("a log without its end keeps its beginning to the byte, also topics that are not decoded") {
        val whole = wpilogBytes(LOG + PHOTO)
        inFolder { folder ->
            checkAll(60, Arb.int(6, whole.size), Arb.element(0, 1, 30)) { size, noise ->
                // Behind half a record, noise could be its other half.
                val log = folder.with("a.wpilog", if (noise == 0) whole.copyOf(size) else whole + ByteArray(noise) { -1 })
                if (badlog("recover", log, "-o", folder / "b.wpilog", "--force").code == ExitCode.NOTHING) return@checkAll
                val clean = (folder / "b.wpilog").readBytes()
                clean.toList() shouldBe whole.copyOf(clean.size).toList()
            }
        }
    }

    test("a log with lost records keeps all others to the byte, also topics that are not decoded") {
        inFolder { folder ->
            val whole = wpilogBytes(LOG + PHOTO)
            val unknown = byteArrayOf(0, 99, 1, 5, 1)
            val log = folder.with("a.wpilog", whole.copyOf(whole.size - 22) + unknown + whole.takeLast(22))
            val json = badlogJson("recover", log, "-o", folder / "b.wpilog").json.single()
            json.getValue("leftOut").jsonArray.size shouldBe 0
            (folder / "b.wpilog").readBytes().toList() shouldBe whole.toList()
        }
    }

    test("a .wpilog file without a WPILOG's first bytes is refused, and not read as a table") {
        inFolder { folder ->
            val whole = wpilogBytes(LOG)
            val garbage = folder.with("a.wpilog", "GARBAGE!".encodeToByteArray() + whole.drop(8))
            val ended = badlog("recover", garbage, "-o", folder / "b.wpilog")
            ended.code shouldBe ExitCode.NOTHING
            val table = "x,y\n1,2\n3" + "\u0000".repeat(4) + "\n"
            badlog("recover", folder.with("t.wpilog", table), "-o", folder / "b.wpilog").err shouldContain "does not begin like one"
            badlogJson("info", folder / "t.wpilog", folder.with("whole.wpilog", whole)).json.map { it.getValue("status").jsonPrimitive.content }
                .shouldContainExactly("failed", "whole")
            badlog("recover", folder.with("t.csv", table), "-o", folder / "b.csv").code shouldBe ExitCode.SALVAGED
            (folder / "b.wpilog").exists() shouldBe false
            badlog("recover", folder.with("empty.wpilog", "")).err shouldContain "nothing can be recovered. The file is empty"
            badlog("convert", folder / "empty.wpilog", "--to", "bag").err shouldContain "nothing can be converted. The file is empty"
            val later = folder.with("later.wpilog", whole.copyOf(7) + 2 + whole.drop(8))
            badlog("recover", later).err shouldContain "version 2"
        }
    }
})
