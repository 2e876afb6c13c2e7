package badlog.window.theme

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.SolidColor
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.graphics.vector.addPathNodes
import androidx.compose.ui.unit.dp
import badlog.core.analysis.Graph

/** The window's icons: lines on a grid of 16 by 16. */
internal object Icons {
    val Folder = icon("M2 4.5 V12.5 H14 V5.5 H7.5 L6 3.5 H2 Z")
    val Pin = icon("M6 2.5 H10 L9.5 7 L11.5 9 H4.5 L6.5 7 Z M8 9 V13.5")
    val Undo = icon("M5.5 3.5 L2.5 6.5 L5.5 9.5 M2.5 6.5 H9.5 A3.5 3.5 0 0 1 9.5 13.5 H6")
    val Redo = icon("M10.5 3.5 L13.5 6.5 L10.5 9.5 M13.5 6.5 H6.5 A3.5 3.5 0 0 0 6.5 13.5 H10")
    val Close = icon("M4 4 L12 12 M12 4 L4 12")
    val Search = icon("M7 3 A4 4 0 1 0 7 11 A4 4 0 1 0 7 3 M10 10 L13.5 13.5")
    val Play = icon("M5 3 L12.5 8 L5 13 Z")
    val Pause = icon("M5 3.5 V12.5 M11 3.5 V12.5")
    val Loop = icon("M3 7 V5.5 H12 M10 3 L12.5 5.5 L10 8 M13 9 V10.5 H4 M6 13 L3.5 10.5 L6 8")
    val List = icon("M2.5 4 H13.5 M2.5 8 H13.5 M2.5 12 H13.5")
    val Table = icon("M2.5 3 H13.5 V13 H2.5 Z M2.5 6.5 H13.5 M6.5 6.5 V13")
    val Graph = icon("M2.5 2.5 V13.5 H13.5 M4.5 10 L7 6.5 L9.5 9 L13 4")
    val Chart = icon("M2.5 13.5 H13.5 M4.5 13.5 V8 M8 13.5 V3 M11.5 13.5 V6", width = 1.8f)
    val Tree = icon("M3 3 H7 M5 3 V12.5 H8 M5 7.5 H8 M9.5 7.5 H13.5 M9.5 12.5 H13.5")
    val Compare = icon("M2.5 11 L6 5 L9 9 L13.5 3 M2.5 13.5 L6 8.5 L9 12 L13.5 7.5")
    val Share = icon("M8 10 V2.5 M5 5.5 L8 2.5 L11 5.5 M3 9 V13.5 H13 V9")
    val Layout = icon("M2.5 3 H13.5 V13 H2.5 Z M2.5 8 H13.5 M6.5 3 V13")
    val Help = icon("M5.5 6 A2.5 2.5 0 1 1 8 8.5 V10 M8 12.5 V12.6")
    val Sun = icon("M8 5 A3 3 0 1 0 8 11 A3 3 0 1 0 8 5 M8 1.5 V2.5 M8 13.5 V14.5 M1.5 8 H2.5 M13.5 8 H14.5")
    val Up = icon("M4 10 L8 6 L12 10")
    val Down = icon("M4 6 L8 10 L12 6")
    val Right = icon("M6 4 L10 8 L6 12")
    val More = icon("M8 3.5 V3.6 M8 8 V8.1 M8 12.5 V12.6", width = 2f)
    val Add = icon("M8 3 V13 M3 8 H13")
    val Remove = icon("M3 8 H13")
    val Back = icon("M6.5 3.5 L2.5 7.5 L6.5 11.5 M2.5 7.5 H10 A3 3 0 0 1 10 13.5 H7")
    val Grow = icon("M2.5 2.5 H13.5 M2.5 13.5 H13.5 M8 4.5 V11.5 M6 6.5 L8 4.5 L10 6.5 M6 9.5 L8 11.5 L10 9.5")
    val Shrink = icon("M2.5 6.5 H13.5 M2.5 9.5 H13.5 M8 1.5 V4.5 M6.5 3 L8 4.5 L9.5 3 M8 14.5 V11.5 M6.5 13 L8 11.5 L9.5 13")
    val Check = icon("M3 8.5 L6.5 12 L13 4.5")
    val Warning = icon("M8 2.5 L14 13 H2 Z M8 6.5 V9.5 M8 11.3 V11.4")
    val Copy = icon("M5.5 5.5 H13 V13.5 H5.5 Z M3 10.5 V2.5 H10.5")
    val Sort = icon("M2.5 4 H11 M2.5 8 H8 M2.5 12 H5 M11.5 7 V12.5 M9.5 10.5 L11.5 12.5 L13.5 10.5")
    val Hide = icon("M1.5 8 C4 4 12 4 14.5 8 C12 12 4 12 1.5 8 M3 13.5 L13 2.5")
    val Robot = icon("M3 6 H13 V13 H3 Z M8 6 V3 M8 2.5 V2.6 M6 9 V9.6 M10 9 V9.6 M1.5 8.5 V10.5 M14.5 8.5 V10.5")
    val Reset = icon("M3 8 A5 5 0 1 0 5 4 M5 1.5 V4.5 H8")

    val Wave = icon("M1.5 9.5 L4.5 4.5 L8 11 L11 6 L14.5 9.5")
    val Lanes = icon("M1.5 5.5 H6.5 V10.5 H11 V5.5 H14.5")
    val Formula =
        icon("M10.5 3.2 C8.8 2 7.8 3 7.5 4.8 L6.2 11.5 C5.8 13.6 4.6 14 3.2 13 M4.6 6.8 H10 M10.5 9.2 L13.8 12.8 M13.8 9.2 L10.5 12.8")
    val Flag = icon("M4 14 V2.5 H12.5 L10 5.5 L12.5 8.5 H4")
    val Diamond = icon("M8 2 L14 8 L8 14 L2 8 Z M8 5.5 V8.5 M8 10.5 V10.6")
    val Sigma = icon("M12.5 4.5 V3 H4 L8.5 8 L4 13 H12.5 V11.5")
    val Note = icon("M3 2.5 H13 V10 L9.5 13.5 H3 Z M13 10 H9.5 V13.5 M5.5 5.5 H10.5 M5.5 8 H8.5")
    val Video = icon("M1.5 4 H10.5 V12 H1.5 Z M10.5 7 L14.5 4.5 V11.5 L10.5 9")
    val Wheels = icon("M4.5 4.5 H11.5 V11.5 H4.5 Z M2.5 2 V7 M13.5 2 V7 M2.5 9 V14 M13.5 9 V14")
    val PreviousFrame = icon("M6.5 4 L2.5 8 L6.5 12 M2.5 8 H13.5")
    val NextFrame = icon("M9.5 4 L13.5 8 L9.5 12 M13.5 8 H2.5")
    val Link = icon("M6.5 9.5 L9.5 6.5 M7.5 5 L9.5 3 A2.5 2.5 0 0 1 13 6.5 L11 8.5 M8.5 11 L6.5 13 A2.5 2.5 0 0 1 3 9.5 L5 7.5")
    val Info = icon("M8 2 A6 6 0 1 0 8 14 A6 6 0 1 0 8 2 M8 7.5 V11 M8 5 V5.1")

    private fun icon(path: String, width: Float = 1.4f): ImageVector =
        ImageVector.Builder(defaultWidth = 16.dp, defaultHeight = 16.dp, viewportWidth = 16f, viewportHeight = 16f)
            .addPath(
                pathData = addPathNodes(path),
                stroke = SolidColor(Color.Black),
                strokeLineWidth = width,
                strokeLineCap = StrokeCap.Round,
                strokeLineJoin = StrokeJoin.Round,
            )
            .build()
}
