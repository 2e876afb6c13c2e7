package badlog.release

import com.fasterxml.jackson.databind.ObjectMapper
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.io.ByteArrayInputStream
import java.io.File
import java.io.InputStream
import java.time.Instant
import java.time.ZoneId
import java.util.zip.GZIPInputStream
import java.util.zip.ZipInputStream

class ArchivesProof : FunSpec({
    val archives = RELEASE.listFiles { file -> file.name.endsWith(".zip") || file.name.endsWith(".tar.gz") || file.extension == "whl" }.orEmpty().sorted()

    test("SHA256SUMS has the checksum of each download") {
        val sums = File(RELEASE, "SHA256SUMS").readLines().associate { it.substringAfter("  ") to it.substringBefore("  ") }
        val downloads = RELEASE.listFiles().orEmpty().filter { it.name != "SHA256SUMS" }
        sums.keys shouldBe downloads.map { it.name }.toSet()
        for (download in downloads) sums[download.name] shouldBe sha256Of(download.readBytes())
    }

    test("a release has the files for each kind of user, all of one version") {
        val names = RELEASE.list().orEmpty().toList()
        names shouldContainAll listOf(
            "badlog-$VERSION.zip",
            "badlog-conformance-$VERSION.zip",
            "badlog-cpp-$VERSION.zip",
            "badlog-docs-$VERSION.zip",
            "badlog-html-$VERSION.zip",
            "badlog-robot-$VERSION.zip",
            "badlog-season-$VERSION.zip",
            "badlog-vendordep-2026-$VERSION.zip",
            "badlog-vendordep-2027-$VERSION.zip",
            "badlog-$VERSION-$PLATFORM.cdx.json",
        )
        val ending = if (PLATFORM.startsWith("windows")) "zip" else "tar.gz"
        names shouldContainAll listOf("badlog-$VERSION-$PLATFORM.$ending", "badlog-viewer-$VERSION-$PLATFORM.$ending")
        names.filter { VERSION !in it && it != "SHA256SUMS" }.shouldBeEmpty()
    }

    test("docs/install.md names each download").config(enabledOrReasonIf = IF_LINUX) {
        val guide = File(ROOT, "docs/install.md").readText()
        RELEASE.list().orEmpty().filter { it.replace(PLATFORM, "linux-x64") !in guide }.shouldBeEmpty()
    }

    test("a release has each download that docs/install.md lists, and its checksum").config(enabledOrReasonIf = IF_LINUX) {
        val rows = File(ROOT, "docs/install.md").readLines().dropWhile { it != "| download | is |" }.drop(2).takeWhile { it.startsWith("|") }
        val named = rows.flatMap { row -> Regex("`(badlog-[^`]*)`").findAll(row.substringBefore(" | ")).map { it.groupValues[1] } }
        named.size shouldBeGreaterThan 10
        val sums = File(RELEASE, "SHA256SUMS").readLines().map { it.substringAfter("  ") }
        val wanted = named.map { it.replace("linux-x64", PLATFORM) }.filterNot { isOptional(it) }
        (wanted - sums.toSet()).shouldBeEmpty()
    }

    test("the conformance download has every log of the corpus, and its expected content") {
        val root = "badlog-conformance-$VERSION"
        val packed = entriesOf(File(RELEASE, "$root.zip")).map { it.name }.filterNot { it.endsWith("/") }.toSet()
        for ((folder, source) in listOf("bags" to "core/conformance", "logs" to "libraries/formats/conformance")) {
            val corpus = File(ROOT, source)
            val files = corpus.walk().filter { it.isFile }.map { it.relativeTo(corpus).invariantSeparatorsPath }.toList()
            packed.filter { it.startsWith("$root/$folder/") }.toSet() shouldBe files.map { "$root/$folder/$it" }.toSet()
            val logs = files.filterNot { it.endsWith(".json") || it.endsWith(".md") || '/' in it }
            logs.size shouldBeGreaterThan 10
            logs.filterNot { "${it.substringBeforeLast('.')}.json" in files || "$it.json" in files }.shouldBeEmpty()
        }
    }

    test("the guides are also a site") {
        val names = entriesOf(File(RELEASE, "badlog-docs-$VERSION.zip")).map { it.name.removePrefix("badlog-docs-$VERSION/") }
        names shouldContainAll listOf("docs/README.md", "samples/practice.bag", "site/index.html", "site/search-index.js", "site/api/index.html")
        names shouldContainAll listOf("site/samples/qualification-42.bag.html", "site/report/index.html")
    }

    test("no archive contains the time of its build, so that the same commit makes the same bytes") {
        val commit = Instant.ofEpochSecond(System.getProperty("badlog.commitTime").toLong())
        archives.flatMap { archive ->
            val entries = entriesOf(archive)
            entries.size shouldBeGreaterThan 1
            entries.filter { it.time > commit }.map { "${archive.name}: ${it.name}, ${it.time}" }
        }.shouldBeEmpty()
    }

    test("each jar in a download is badlog's own, or in the bill of materials with its checksum") {
        val bill = ObjectMapper().readTree(File(RELEASE, "badlog-$VERSION-$PLATFORM.cdx.json"))
        val known = bill["components"].flatMap { it.path("hashes") }.map { it["content"].asText() }.toSet()
        archives.flatMap { archive ->
            // This jar is part of Java, which has an entry of its own.
            val jars = entriesOf(archive) { it.endsWith(".jar") && !it.endsWith("/jrt-fs.jar") }
            jars.filter { it.sha256 != null && !isOwn(it.name) && it.sha256 !in known }.map { "${archive.name}: ${it.name}" }
        }.shouldBeEmpty()
    }
})

/** Returns whether some machines cannot make the download [name]; `release` reports the reason. */
private fun isOptional(name: String) = name.endsWith(".deb") || (name.startsWith("badlog-cpp-") && PLATFORM in name)

private class Entry(val name: String, val time: Instant, val sha256: String?)

/** Returns the entries of [archive], and the checksums of the entries that are [hashed]. */
private fun entriesOf(archive: File, hashed: (String) -> Boolean = { false }): List<Entry> = archive.inputStream().buffered().use { stream ->
    if (archive.name.endsWith(".tar.gz")) tarEntries(GZIPInputStream(stream), hashed) else zipEntries(stream, hashed)
}

private fun zipEntries(stream: InputStream, hashed: (String) -> Boolean): List<Entry> {
    val zip = ZipInputStream(stream)
    return generateSequence { zip.nextEntry }.map { entry ->
        // A zip has local times without a time zone.
        val time = entry.timeLocal.atZone(ZoneId.of("UTC")).toInstant()
        Entry(entry.name, time, if (hashed(entry.name)) sha256Of(zip.readBytes()) else null)
    }.toList()
}

/** Returns the entries of a tar archive: blocks of 512 bytes, with a header before each file. */
private fun tarEntries(stream: InputStream, hashed: (String) -> Boolean): List<Entry> {
    val entries = ArrayList<Entry>()
    var longName: String? = null
    while (true) {
        val header = stream.readNBytes(BLOCK)
        if (header.size < BLOCK || header.all { it == 0.toByte() }) return entries
        val size = octal(header, 124, 12).toInt()
        val kind = header[156].toInt().toChar()
        val shortName = text(header, 345, 155).let { prefix -> if (prefix.isEmpty() || kind == 'L') "" else "$prefix/" } + text(header, 0, 100)
        val name = longName ?: shortName
        longName = null
        val content = stream.readNBytes((size + BLOCK - 1) / BLOCK * BLOCK)
        if (kind == 'L') {
            longName = text(content, 0, size)
        } else {
            val bytes = ByteArrayInputStream(content, 0, size)
            entries += Entry(name, Instant.ofEpochSecond(octal(header, 136, 12)), if (hashed(name)) sha256Of(bytes.readBytes()) else null)
        }
    }
}

private fun octal(bytes: ByteArray, from: Int, length: Int): Long = text(bytes, from, length).trim().ifEmpty { "0" }.toLong(8)

private fun text(bytes: ByteArray, from: Int, length: Int): String = bytes.decodeToString(from, from + length).substringBefore('\u0000')

private fun isOwn(path: String): Boolean = path.substringAfterLast('/').removePrefix("badlog-").substringBefore("-$VERSION").removeSuffix("-jvm") in OWN

private val OWN = File(ROOT, "settings.gradle.kts").readLines().filter { it.startsWith("include(") }
    .map { it.substringAfter(':').substringBefore('"') }.toSet() + "robot"

private const val BLOCK = 512
