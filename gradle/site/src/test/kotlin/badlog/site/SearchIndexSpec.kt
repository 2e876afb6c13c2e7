package badlog.site

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SearchIndexSpec : FunSpec({
    test("the index is one valid script for any content of a guide") {
        val index = SearchIndex()
        index.add("page.html#a", "Page", "Quotes \" and \\", "a\nb\t</script>\u2028")
        index.script() shouldBe "window.searchIndex = [\n[\"page.html#a\",\"Page\",\"Quotes \\\" and \\\\\",\"a b \\u003c/script>\\u2028\"]\n];\n"
    }
})
