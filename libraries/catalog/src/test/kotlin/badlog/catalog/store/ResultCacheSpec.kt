package badlog.catalog.store

import badlog.files.LogFile
import badlog.files.windows.WindowsFiles
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeIn
import io.kotest.matchers.shouldBe
import kotlinx.serialization.Serializable
import kotlinx.serialization.builtins.serializer
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.hours

@Serializable
private enum class Color { RED, BLUE }

@Serializable
private sealed interface Shape {
    @Serializable
    data class Round(val radius: Double) : Shape

    @Serializable
    data object None : Shape
}

@Serializable
private data class Names(val of: String, val names: List<String>, val more: Pair<Int, Long> = 1 to 2L)

@Serializable
private data class Kept(
    val text: String?,
    val number: Double,
    val color: Color,
    val isTrue: Boolean,
    val shapes: List<Shape>,
    val names: Names,
)

class ResultCacheSpec : FunSpec({
    val file = LogFile(Path.of("1.bag"), 10, 20)

    fun cacheIn(folder: Path, pause: Duration) = ResultCache(folder.resolve("cache"), "q", String.serializer(), pause)

    test("results are saved during a run, but not after every file") {
        for ((pause, kept) in listOf(Duration.ZERO to "found", 1.hours to null)) {
            val folder = tempdir().toPath()
            cacheIn(folder, pause).run {
                set(file, "found")
                saveNowAndThen()
            }
            cacheIn(folder, pause)[file] shouldBe kept
        }
    }

    test("stored results of any content are read back unchanged") {
        val folder = tempdir().toPath()
        fun cache() = ResultCache(folder, "q", Kept.serializer())
        val files = List(1000) { LogFile(Path.of("$it.bag"), 10, 20) }
        fun kept(i: Int) = Kept(
            "ä $i".takeIf { i > 0 },
            if (i == 1) Double.NaN else i / 3.0,
            Color.BLUE,
            i % 2 == 0,
            listOf(Shape.Round(Double.NaN), Shape.None).take(i),
            Names("x".repeat(i), List(i % 7) { "name $it" }, -i to Long.MIN_VALUE),
        )
        cache().run {
            files.forEachIndexed { i, file -> set(file, kept(i)) }
            save()
        }
        cache().run { files.forEachIndexed { i, file -> get(file) shouldBe kept(i) } }
    }

    test("a damaged cache, and one of another question, are ignored") {
        val folder = tempdir().toPath()
        cacheIn(folder, Duration.ZERO).run {
            set(file, "found")
            save()
        }
        val kept = Files.list(folder.resolve("cache")).use { it.toList() }.single()
        val whole = Files.readAllBytes(kept)
        for (place in whole.indices) {
            Files.write(kept, whole.copyOf().also { it[place] = (it[place] + 1).toByte() })
            // A few bytes have no effect, such as the name of the system that packed the file.
            cacheIn(folder, Duration.ZERO)[file] shouldBeIn listOf(null, "found")
        }
        for (size in whole.indices) {
            Files.write(kept, whole.copyOf(size))
            cacheIn(folder, Duration.ZERO)[file] shouldBe null
        }
        Files.write(kept, whole)
        cacheIn(folder, Duration.ZERO)[file] shouldBe "found"
    }

    test("on Windows, a cache that is read-only or open elsewhere stays intact without leftovers, and is updated later") {
        WindowsFiles().use { windows ->
            val folder = windows.folder.resolve("cache")
            fun names() = Files.newDirectoryStream(folder).use { all -> all.map { "${it.fileName}" } }
            val cache = cacheIn(windows.folder, Duration.ZERO)
            cache[file] = "old"
            cache.save()
            val kept = names().single()
            windows.whileOpen(folder.resolve(kept)) {
                cache[file] = "new"
                cache.save()
                names() shouldBe listOf(kept)
                cacheIn(windows.folder, Duration.ZERO)[file] shouldBe "old"
            }
            cache.save()
            cacheIn(windows.folder, Duration.ZERO)[file] shouldBe "new"
            windows.protect(folder.resolve(kept))
            cache[file] = "newer"
            cache.save()
            names() shouldBe listOf(kept)
            cacheIn(windows.folder, Duration.ZERO)[file] shouldBe "new"
            windows.openCount shouldBe 0
        }
    }
})
