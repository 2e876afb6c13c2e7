package badlog.catalog.match

import badlog.files.NotReadException
import badlog.files.UnreadableFileException
import badlog.signals.match.files.MatchManifest
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.PropertyTesting
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.arabic
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.merge
import io.kotest.property.arbitrary.printableAscii
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import java.io.ByteArrayOutputStream
import java.io.File
import java.nio.charset.Charset
import java.nio.file.Path
import java.util.zip.GZIPOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.readText
import kotlin.io.path.walk
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.random.Random

private const val LOG = "Time,A\n0,1\n1,2\n"
private val MANIFEST = MatchManifest(emptyList()).text()

private fun zipOf(vararg entries: Pair<String, ByteArray>, charset: Charset = Charsets.UTF_8): ByteArray {
    val bytes = ByteArrayOutputStream()
    ZipOutputStream(bytes, charset).use { zip ->
        for ((name, content) in entries) {
            zip.putNextEntry(ZipEntry(name))
            zip.write(content)
            zip.closeEntry()
        }
    }
    return bytes.toByteArray()
}

private fun gzip(content: ByteArray) = ByteArrayOutputStream().also { bytes -> GZIPOutputStream(bytes).use { it.write(content) } }.toByteArray()

class MatchZipSpec : FunSpec({
    /** The content of each log of the ZIP [bytes], by its name. */
    fun unpacked(bytes: ByteArray): Map<String, String> {
        val folder = tempdir().toPath()
        val file = (folder / "m.zip").apply { writeBytes(bytes) }
        val target = (folder / "logs").createDirectories()
        val logs = MatchZip(file).use { zip -> zip.unpack(target) {}.mapValues { it.value.readText() } }
        // Nothing is anywhere else.
        folder.walk().map { folder.relativize(it) }.toList().all { it == Path.of("m.zip") || it.startsWith("logs") } shouldBe true
        return logs
    }

    fun said(bytes: ByteArray): String = shouldThrow<NotReadException> { unpacked(bytes) }.message.orEmpty()

    fun zip(vararg entries: Pair<String, String>) = zipOf(*entries.map { (name, text) -> name to text.encodeToByteArray() }.toTypedArray())

    test("a ZIP from Windows has its names with backslashes, or in Windows' own characters") {
        unpacked(zip("match\\robot.csv" to LOG, "match\\ds\\a.dslog" to "x", "match\\" to "")).keys shouldContainExactly setOf("match/robot.csv", "match/ds/a.dslog")
        val dos = Charset.forName("IBM437")
        unpacked(zipOf("Prüfstand.csv" to LOG.encodeToByteArray(), charset = dos)) shouldBe mapOf("Prüfstand.csv" to LOG)
        said(zip("..\\robot.csv" to LOG)) shouldContain "not the name of a file on every system"
        said(zip("\\robot.csv" to LOG)) shouldContain "not the name of a file on every system"
    }

    test("names beside a match.json are relative to it, and there is only one") {
        unpacked(zip("m/match.json" to MANIFEST, "m/a.csv" to LOG, "m/__MACOSX/._a.csv" to "x", "m/.hidden.csv" to "x")).keys shouldContainExactly setOf("a.csv")
        said(zip("a/match.json" to MANIFEST, "b/match.json" to MANIFEST, "a/a.csv" to LOG)) shouldContain "several match.json"
    }

    test("a log outside of the folder of match.json is not taken for one inside") {
        val logs = mapOf("robot.csv" to "Time,A\n0,1\n", "day/robot.csv" to "Time,B\n0,2\n", "day/eye/robot.csv" to "Time,C\n0,3\n", "other/robot.csv" to "Time,D\n0,4\n")
        for (order in listOf(logs.toList(), logs.toList().reversed())) {
            unpacked(zip("day/match.json" to MANIFEST, *order.toTypedArray())) shouldBe mapOf(
                "../robot.csv" to logs["robot.csv"],
                "robot.csv" to logs["day/robot.csv"],
                "eye/robot.csv" to logs["day/eye/robot.csv"],
                "../other/robot.csv" to logs["other/robot.csv"],
            )
            unpacked(zip("day/eye/match.json" to MANIFEST, *order.toTypedArray())).keys shouldBe setOf("../../robot.csv", "../robot.csv", "robot.csv", "../../other/robot.csv")
        }
    }

    test("another program's match.json is passed over, however many and large they are") {
        val foreign = "{\"key\":\"2026test_qm4\"}"
        unpacked(zip("a/match.json" to foreign, "b/match.json" to foreign, "b/b.csv" to LOG)) shouldBe mapOf("b/b.csv" to LOG)
        unpacked(zip("a/match.json" to foreign, "b/match.json" to MANIFEST, "b/b.csv" to LOG)) shouldBe mapOf("b.csv" to LOG)
        val large = "{\"key\":\"" + Random(3).nextBytes(2 shl 20).joinToString("") { "${it.toInt() and 7}" } + "\"}"
        unpacked(zip("match.json" to large, "b.csv" to LOG)) shouldBe mapOf("b.csv" to LOG)
    }

    test("a file that match.json names is a log, whatever its name") {
        val manifest = "{\"version\":1,\"files\":[{\"name\":\"robot\"},{\"name\":\"x/eye.dat\"}]}"
        unpacked(zip("m/match.json" to manifest, "m/robot" to LOG, "m/x/eye.dat" to LOG, "m/other" to "x", "robot" to "x")).keys shouldContainExactly setOf("robot", "x/eye.dat")
    }

    // Windows has no such names.
    test("whatever the names of the logs, the ZIP that is written of them is read with all of them").config(enabledIf = { File.separatorChar == '/' }) {
        val folder = tempdir().toPath()
        val names = Arb.string(1..60, Codepoint.printableAscii().merge(Codepoint.arabic())).filter { '/' !in it && it != "." && it != ".." }
        val endings = listOf("", ".wpilog", ".csv", ".bag.gz", ".", " ", ".csv ", "é".repeat(50) + ".wpilog")
        val usual = listOf("match.json", "Match.json", "CON.wpilog", ".wpilog", "robot.", "robot", "x".repeat(200), "x".repeat(220) + ".csv")
        var run = 0
        checkAll(iterations = 100, Arb.list(names, 1..6), Arb.element(endings), Arb.element(usual)) { some, ending, other ->
            val here = (folder / "${run++}").createDirectories()
            val files = (some.flatMapIndexed { i, name -> listOf("$i/$name$ending", "x$i/$name$ending") } + "o/$other").distinct().mapIndexed { i, name ->
                val place = (here / name.substringBefore('/')).createDirectories()
                place.resolve(name.substringAfter('/')).apply { writeText("Time,A\n0,$i\n") }
            }
            val bytes = ByteArrayOutputStream().also { writeMatchZip(files.map { FileForZip(it, null, null, null) }, it) }.toByteArray()
            unpacked(bytes).values.sorted() shouldBe files.map { it.readText() }.sorted()
        }
    }

    test("a log that is compressed with xz is in no ZIP that is written") {
        val file = tempdir().toPath() / "eye.wpilogxz"
        file.writeBytes(byteArrayOf(0xFD.toByte(), 0x37, 0x7A, 0x58, 0x5A, 0, 0, 4))
        shouldThrow<NotReadException> { writeMatchZip(listOf(FileForZip(file, null, 0.0, null)), ByteArrayOutputStream()) }.message shouldBe
            "$file is compressed with xz, which badlog does not read in a ZIP; make a WPILOG of it with badlog convert."
    }

    test("two names that are one file on some system are refused, so that none replaces the other") {
        said(zip("a.csv" to LOG, "A.csv" to LOG)) shouldContain "“a.csv” and “A.csv” in it are one name"
        said(zip("m/a?.csv" to LOG, "m/a*.csv" to LOG)) shouldContain "are one name on some systems; rename one"
        said(zip("M/a.csv" to LOG, "m/a.csv" to LOG)) shouldContain "are one name"
        // Composed and decomposed, which is one name on macOS.
        said(zip("\u00e9.csv" to LOG, "e\u0301.csv" to LOG)) shouldContain "are one name"
        unpacked(zip("./a.csv" to LOG, "./x/b.csv" to LOG)).keys shouldContainExactly setOf("a.csv", "x/b.csv")
        unpacked(zip("a/x.csv" to LOG, "b/x.csv" to "Time,B\n0,3\n")) shouldBe mapOf("a/x.csv" to LOG, "b/x.csv" to "Time,B\n0,3\n")
    }

    test("a log with changed bytes is damaged, whether compressed or not") {
        val bytes = zipOf("a.csv" to LOG.encodeToByteArray()).also { plain ->
            // The sum of the entry at the end of the ZIP.
            val at = plain.indices.last { plain[it] == 'P'.code.toByte() && plain[it + 1] == 'K'.code.toByte() && plain[it + 2] == 1.toByte() }
            plain[at + 16] = (plain[at + 16] + 1).toByte()
        }
        said(bytes) shouldContain "“a.csv” in it is damaged; make the ZIP again."
    }

    test("whatever grows without end is refused, also inside a compressed log, before it fills the disk") {
        val zeros = ByteArray(65 shl 20)
        said(zipOf("a.csv" to zeros)) shouldContain "grows more than 200 times"
        said(zipOf("a.csv.gz" to gzip(zeros))) shouldContain "“a.csv.gz” in it grows more than 200 times"
        said(zipOf("a.csv" to gzip(zeros))) shouldContain "grows more than 200 times"
        said(zipOf("a.wpilogxz" to byteArrayOf(0xFD.toByte(), 0x37, 0x7A, 0x58, 0x5A, 0))) shouldContain "compressed with xz"
        // Many logs that are small enough alone add up.
        val few = ByteArray(6 shl 20)
        said(zipOf(*Array(12) { "$it.csv" to few })) shouldContain "“10.csv” in it grows more than 200 times"
        said(zipOf(*Array(12) { "$it.csv.gz" to gzip(few) })) shouldContain "“10.csv.gz” in it grows more than 200 times"
        // A log that recorded nearly nothing is small, too.
        unpacked(zipOf("a.csv" to ByteArray(8 shl 20))).keys shouldBe setOf("a.csv")
        val random = Random(1).nextBytes(4 shl 20)
        unpacked(zipOf("a.csv.gz" to gzip(random))).keys shouldBe setOf("a.csv.gz")
        // A log that a robot did not finish is read up to its end.
        unpacked(zipOf("a.csv.gz" to gzip(random).copyOf(100_000))).keys shouldBe setOf("a.csv.gz")
    }

    test("an unreadable match is tried again if its logs only lack something that may be there later") {
        val folder = tempdir().toPath()
        fun failure(vararg entries: Pair<String, String>) = shouldThrow<UnreadableFileException> {
            MatchMaker.make((folder / "m.zip").apply { writeBytes(zip(*entries)) }, folder / "made.wpilog") {}
        }
        // CTRE's converter may be installed later.
        failure("rio.hoot" to "rio").let { (it is NotReadException) to ("no robot's log" in it.message) } shouldBe (false to true)
        failure("a.wpilog" to "%PDF-1.4").let { (it as NotReadException).why.isLasting } shouldBe true
    }

    test("a ZIP of other files is not one of a match, however many they are") {
        val folder = tempdir().toPath()
        val many = Array(600) { "photo $it.jpg" to ByteArray(3) }
        val file = folder / "photos.zip"
        file.writeBytes(zipOf(*many))
        MatchMaker.isSource(file) shouldBe false
        file.writeBytes(zipOf(*many, "a.csv" to LOG.encodeToByteArray(), "../b.jpg" to ByteArray(1)))
        MatchMaker.isSource(file) shouldBe true
        MatchZip(file).use { zip -> zip.unpack((folder / "logs").createDirectories()) {}.keys shouldBe setOf("a.csv") }
        said(zipOf(*Array(501) { "$it.csv" to ByteArray(3) })) shouldContain "more than 500 logs"
    }

    test("a ZIP with changed or missing bytes is unpacked unchanged, or refused with the reason") {
        val random = Random(99)
        val logs = mapOf("a.csv" to LOG, "ds/b.csv" to "Time,B\n" + (0..200).joinToString("\n") { "$it,${it * it}" })
        val whole = zip(*logs.toList().toTypedArray())
        repeat(PropertyTesting.defaultIterationCount) { run ->
            val bytes = whole.copyOf(if (run % 3 == 0) random.nextInt(4, whole.size) else whole.size)
            repeat(random.nextInt(1, 6)) { bytes[random.nextInt(4, bytes.size)] = random.nextInt().toByte() }
            try {
                // Only names may have changed.
                unpacked(bytes).values.all { it in logs.values } shouldBe true
            } catch (e: NotReadException) {
                e.why.message.endsWith(".") shouldBe true
            }
        }
    }
})
