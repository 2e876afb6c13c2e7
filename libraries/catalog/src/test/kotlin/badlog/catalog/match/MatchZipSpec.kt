package badlog.catalog.match

import badlog.files.NotReadException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.PropertyTesting
import java.io.ByteArrayOutputStream
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
import kotlin.random.Random

private const val LOG = "Time,A\n0,1\n1,2\n"

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
        said(zip("..\\robot.csv" to LOG)) shouldContain "not the name of a file in a ZIP"
        said(zip("\\robot.csv" to LOG)) shouldContain "not the name of a file in a ZIP"
    }

    test("names beside a match.json are relative to it, and there is only one") {
        unpacked(zip("m/match.json" to "{}", "m/a.csv" to LOG, "m/__MACOSX/._a.csv" to "x", "m/.hidden.csv" to "x")).keys shouldContainExactly setOf("a.csv")
        said(zip("a/match.json" to "{}", "b/match.json" to "{}", "a/a.csv" to LOG)) shouldContain "several match.json"
    }

    test("two names that are one file on some system are refused, so that none replaces the other") {
        said(zip("a.csv" to LOG, "A.csv" to LOG)) shouldContain "“a.csv” and “A.csv” in it are one name"
        said(zip("m/a?.csv" to LOG, "m/a*.csv" to LOG)) shouldContain "are one name on some systems; rename one"
        said(zip("M/a.csv" to LOG, "m/a.csv" to LOG)) shouldContain "are one name"
        unpacked(zip("a/x.csv" to LOG, "b/x.csv" to "Time,B\n0,3\n")) shouldBe mapOf("a/x.csv" to LOG, "b/x.csv" to "Time,B\n0,3\n")
    }

    test("a log whose bytes have changed is damaged, whether compressed or not") {
        val bytes = zipOf("a.csv" to LOG.encodeToByteArray()).also { plain ->
            // The sum of the entry at the end of the ZIP.
            val at = plain.indices.last { plain[it] == 'P'.code.toByte() && plain[it + 1] == 'K'.code.toByte() && plain[it + 2] == 1.toByte() }
            plain[at + 16] = (plain[at + 16] + 1).toByte()
        }
        said(bytes) shouldContain "“a.csv” in it is damaged; make the ZIP again."
    }

    test("whatever grows without end is refused, also inside a compressed log, before it fills the disk") {
        val zeros = ByteArray(8 shl 20)
        said(zipOf("a.csv" to zeros)) shouldContain "grows more than 200 times"
        said(zipOf("a.csv.gz" to gzip(zeros))) shouldContain "“a.csv.gz” in it grows more than 200 times"
        said(zipOf("a.csv" to gzip(zeros))) shouldContain "grows more than 200 times"
        said(zipOf("a.wpilogxz" to byteArrayOf(0xFD.toByte(), 0x37, 0x7A, 0x58, 0x5A, 0))) shouldContain "compressed with xz"
        val random = Random(1).nextBytes(4 shl 20)
        unpacked(zipOf("a.csv.gz" to gzip(random))).keys shouldBe setOf("a.csv.gz")
        // A log that a robot did not finish is read up to its end.
        unpacked(zipOf("a.csv.gz" to gzip(random).copyOf(100_000))).keys shouldBe setOf("a.csv.gz")
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

    test("whatever bytes of a ZIP are changed or missing, its logs are as they were, or a sentence says what is wrong") {
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
