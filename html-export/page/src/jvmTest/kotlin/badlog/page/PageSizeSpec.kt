package badlog.page

import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import java.nio.file.Files

@Tags("InCheck")
internal class PageSizeSpec : FunSpec({
    fun sizeWith(additions: PageAdditions): Long = Files.size(TestPages.of("Time,A\n0,1\n".encodeToByteArray(), "two.csv", additions))

    test("a log of two lines, program, styles and frame together are at most 509,000 bytes") {
        sizeWith(PageAdditions()) shouldBeLessThanOrEqual 509_000L
    }

    test("the built-in rules add at most 18,000 bytes to a page") {
        sizeWith(PageAdditions(rules = RuleSet.BUILT_IN)) - sizeWith(PageAdditions()) shouldBeLessThanOrEqual 18_000L
    }
})
