package badlog.viewer.session.video

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class VideoSpeedSpec : FunSpec({
    test("a step leads to the next speed of the list, from a tenth to ten times the recorded one") {
        speedAfter(1.0, 1) shouldBe 2.0
        speedAfter(1.0, -1) shouldBe 0.5
        speedAfter(1.0, 100) shouldBe 10.0
        speedAfter(1.0, -100) shouldBe 0.1
    }
})
