package badlog.core.text

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FreeNameSpec : FunSpec({
    test("a name that is taken gets the first free number, before its extension") {
        val taken = hashSetOf("a.html", "a (2).html", "b")
        freeName("a", ".html") { it !in taken } shouldBe "a (3).html"
        freeName("b", isFree = taken::add) shouldBe "b (2)"
        freeName("b", isFree = taken::add) shouldBe "b (3)"
        freeName("c", isFree = taken::add) shouldBe "c"
    }

    test("each name is used once, even if a requested one looks like a copy") {
        val names = UniqueNames()
        listOf("a", "a (2)", "a", "a", "a (2)").map(names::give) shouldBe listOf("a", "a (2)", "a (3)", "a (4)", "a (2) (2)")
    }
})
