package badlog.page

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import java.nio.file.Files

internal class PageSizeSpec : FunSpec({
    test("script, styles and frame together are at most 350 kB") {
        val empty = TestPages.of("Time,A\n")
        Files.size(empty) shouldBeLessThanOrEqual 350_000L
    }
})
