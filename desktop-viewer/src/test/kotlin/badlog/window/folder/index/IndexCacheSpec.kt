package badlog.window.folder.index

import badlog.core.recording.Severity
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeSameInstanceAs
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.CRC32

class IndexCacheSpec : FunSpec({
    val entries = List(20) {
        val topics = List(5) { i -> topic("Arm/$i", i + 0.5) }
        val found = listOf(null, LogFound(it, null), LogFound(it, emptyList()), LogFound(it, listOf(FoundRule("Browned out", Severity.ERROR))))
        entry("m$it.bag", MatchFacts("Event", "Final", "$it", "Red"), it * 1000L, topics = topics).copy(found = found[it % 4])
    } + entry("broken.bag", content = Content.UNREADABLE).copy(trouble = "It is broken.", duration = null)

    /** Damage that the check sum does not tell. */
    fun withRightChecksum(bytes: ByteArray): ByteArray {
        val sum = CRC32().apply { update(bytes, 12, bytes.size - 12) }.value.toInt()
        return ByteBuffer.wrap(bytes).putInt(8, sum).array()
    }

    test("what is kept comes back as it was, each text once") {
        val decoded = IndexFormat.decode(IndexFormat.encode(entries))!!
        decoded shouldContainExactly entries
        decoded[3].topics[2].name shouldBeSameInstanceAs decoded[4].topics[2].name
    }

    test("it is kept in the cache's folder, for each folder of logs apart") {
        val home = tempdir().toPath().resolve("made/when/needed")
        val cache = IndexCache(home, Path.of("/logs"))
        cache.load().shouldBeEmpty()
        cache.save(entries)
        cache.load() shouldContainExactly entries
        IndexCache(home, Path.of("/other")).load().shouldBeEmpty()
        Files.list(home).use { it.count() } shouldBe 1
    }

    test("an index that is cut anywhere, or changed in any byte, is as none") {
        val bytes = IndexFormat.encode(entries)
        checkAll(Arb.int(bytes.indices)) { at ->
            IndexFormat.decode(bytes.copyOf(at)).shouldBeNull()
            IndexFormat.decode(bytes.clone().also { it[at] = (it[at] + 1).toByte() }).shouldBeNull()
        }
    }

    test("an index of another version is as none") {
        val bytes = IndexFormat.encode(entries)
        IndexFormat.decode(ByteBuffer.wrap(bytes).putInt(4, IndexFormat.VERSION + 1).array()).shouldBeNull()
    }

    test("no bytes make it throw or ask for much memory, not even with a right check sum") {
        val bytes = IndexFormat.encode(entries)
        checkAll(Arb.int(12 until bytes.size), Arb.int()) { at, value ->
            val damaged = bytes.clone()
            for (i in 0 until minOf(4, bytes.size - at)) damaged[at + i] = (value ushr (8 * i)).toByte()
            IndexFormat.decode(withRightChecksum(damaged))?.let(IndexFormat::encode)
        }
        checkAll(Arb.int(0..400), Arb.byte()) { size, value ->
            val damaged = bytes.copyOf(12) + ByteArray(size) { (it * value).toByte() }
            IndexFormat.decode(withRightChecksum(damaged))
        }
        checkAll(Arb.byteArray(Arb.int(0..200), Arb.byte())) { IndexFormat.decode(it).shouldBeNull() }
    }
})
