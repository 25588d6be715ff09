"""The mesh in the 3D view: curved faces and edges, colours, colour bar, picking, marks.

| module | what is in it |
|---|---|
| `actions` | what commands and scripts call |
| `mesh_display` | one mesh object's drawing: what is built when |
| `view_properties` | the properties of the view object |
| `drawn_mesh` | figures of every element, points and triangles to draw; knows neither Coin nor documents |
| `colouring`, `colour_maps` | a colour for every element, and what the colour bar tells |
| `scene`, `marks`, `fields` | Coin nodes: faces and edges; marked elements; filling by memory copy |
| `edge_density` | element edges fainter, or left out, where elements are small in the view |
| `emphasis` | banner of meshes that are out of date, rings, labels; parts of a mesh alone |
| `panels`, `legend` | pictures on top of the view: colour bar with histogram, report of the element clicked |
| `picking`, `selection` | the element under the mouse; highlight of what is selected |
| `report` | what is told about an element |
"""
