package badlog.page

import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import java.nio.file.Files

internal class PageSizeSpec : FunSpec({
    test("a log of two lines, program, styles, frame and built-in rules together are at most 280,000 bytes") {
        val page = TestPages.of("Time,A\n0,1\n".encodeToByteArray(), "two.csv", PageAdditions(rules = RuleSet.BUILT_IN))
        Files.size(page) shouldBeLessThanOrEqual 280_000L
    }
})
