package badlog.report

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlinx.serialization.builtins.serializer
import java.nio.file.Path
import kotlin.time.Duration
import kotlin.time.Duration.Companion.hours

class ResultCacheSpec : FunSpec({
    fun cacheIn(folder: Path, pause: Duration) = ResultCache(folder.resolve("cache"), "q", String.serializer(), pause)

    test("results are saved while others are still under way, but not every time") {
        for ((pause, kept) in listOf(Duration.ZERO to "found", 1.hours to null)) {
            inFolder { folder ->
                folder.put("1.bag", batteryBag(6.0))
                val file = logsIn(folder).single()
                cacheIn(folder, pause).run {
                    set(file, "found")
                    saveNowAndThen()
                }
                cacheIn(folder, pause)[file] shouldBe kept
            }
        }
    }
})
