import badlog.analysis.LogView
import badlog.bag.BagParser
import kotlinx.browser.document

fun main() {
    val parser = BagParser()
    parser.accept("a,b\n1,2\n".encodeToByteArray())
    val view = LogView.of(parser.finish())
    document.title = view.folders.joinToString { it.name + it.graphs.map { g -> g.title + g.series.map { s -> s.data.size } } + view.problems }
}
