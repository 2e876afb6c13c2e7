package badlog.formats

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.shouldBe

class LogFormatsSpec : FunSpec({
    test("the readable logs are listed with the endings of each kind") {
        READABLE_LOGS shouldBe "bags (.bag, .badbag), CSV files (.csv), WPILOGs (.wpilog), Driver Station logs (.dslog, .dsevents), " +
            "and REV logs (.revlog)"
    }

    test("each ending has its dot and is in lower case, and no two formats share one") {
        LOG_ENDINGS.filterNot { it.startsWith('.') && it == it.lowercase() } shouldBe emptyList()
        LOG_ENDINGS.shouldBeUnique()
    }
})
